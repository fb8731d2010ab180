// When a reader chooses a pixel, a line about this pixel appears below the picture, the picture's
// panel opens, and the address changes.
import { expect, makeReady, open, test } from './fixtures.js';

test('a link that names a pixel selects this pixel, and Back returns to the link', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  // Lay out all of the page, as if the reader had scrolled through the page.
  await page.locator('main > *').evaluateAll(parts => parts.forEach(part => { part.style.contentVisibility = 'visible'; }));
  const figure = page.locator('figure[data-live="step03_nearest"]');
  const link = page.locator('a[href$="#pixel=195,237"]').first();
  await link.scrollIntoViewIfNeeded();
  await figure.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });
  // Playwright may scroll before it clicks, so measure where the link is when it is clicked.
  const placeOfClick = link.evaluate(element => new Promise(done => {
    element.addEventListener('click', () => done(element.getBoundingClientRect().y), { once: true });
  }));
  await link.click();
  const place = await placeOfClick;
  await expect(figure).toBeInViewport();
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('195');
  await expect(figure.locator('.hint')).toHaveText(/^red, t = [\d.]+ .*\(\d+, \d+, \d+\) Copy link$/);
  await expect(figure.locator('.handle-probe')).toHaveAttribute('aria-valuetext', /^column 195, row 237: red, t = /);
  await expect(page.locator('[data-panel] tr.hit')).toHaveCount(1);
  await figure.locator('.handle-probe').press('ArrowRight');
  await expect(page).toHaveURL(/#pixel=196,237$/);
  await link.click();
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('195');
  await page.evaluate(() => history.go(-2));
  // The link may have moved, but by less than a line of text.
  await expect.poll(async () => Math.abs((await link.boundingBox()).y - place)).toBeLessThan(24);
});

test('Back leaves an address as it was, even while a pixel waits to be written', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  const figure = page.locator('figure[data-live="step03_nearest"]');
  await makeReady(figure);
  await page.locator('a[href$="#pixel=195,237"]').first().evaluate(link => link.click());
  await expect(page).toHaveURL(/#pixel=195,237$/);
  // The page writes the pixel 150 ms after the last key.
  await figure.locator('.handle-probe').evaluate(async probe => {
    probe.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }));
    await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
    history.back();
  });
  await expect(page).not.toHaveURL(/#/);
  await page.waitForTimeout(400);
  await expect(page).not.toHaveURL(/#/);
});

test('the first click on a picture opens the panel beside the picture, and the address names the pixel', async ({ page, home }) => {
  await open(page, `${home}step05_phong.html`);
  const [figure, panel] = [page.locator('figure[data-live="step05_phong"]'), page.locator('[data-panel]')];
  await makeReady(figure);
  await expect(panel).toBeHidden();
  // The switches are in one row, and the sliders are in another row.
  const bottoms = kind => figure.locator(`.controls > .${kind}:visible`).evaluateAll(all => all.map(element => Math.round(element.getBoundingClientRect().bottom)));
  const [switches, sliders] = [await bottoms('switch'), await bottoms('range')];
  expect([switches.length, new Set(switches).size, sliders.length, new Set(sliders).size]).toEqual([3, 1, 2, 1]);
  expect(sliders[0]).toBeGreaterThan(switches[0]);
  const { x, y, width } = await figure.locator('.stage').boundingBox();
  await page.mouse.click(x + width / 2, y + width / 4);
  await expect(page).toHaveURL(/#pixel=3\d\d,1\d\d$/);
  const box = await panel.boundingBox();
  expect(box.x).toBeGreaterThan(x + width);
  expect(Math.abs(box.y - y)).toBeLessThan(30);
  // The picture hasn't moved.
  expect((await figure.locator('.stage').boundingBox()).y).toBe(y);
  await panel.locator('summary').click();
  await expect(panel).toBeHidden();
  await figure.locator('.handle-probe').click(); // This chooses the same pixel.
  await expect(panel).toBeVisible();
  await figure.locator('.reset').click();
  await expect(page).not.toHaveURL(/#pixel/);
  await expect(figure.locator('.hint b')).toHaveText('salmon, t = 9.7415');
});

test('a click on the handle of the disc chooses the pixel at the handle, and a drag chooses no pixel', async ({ page, home }) => {
  await open(page, `${home}step02_sphere.html`);
  const figure = page.locator('figure[data-live="step02_sphere"]');
  await makeReady(figure);
  const handle = figure.locator('.handle-point');
  await handle.click();
  await expect(figure.locator('.hint b')).toHaveText('sphere, t = 4');
  await expect(page).toHaveURL(/#pixel=3(19|20),1(79|80)$/);
  const address = page.url();
  await handle.hover();
  await page.mouse.down();
  const { x, y } = await handle.boundingBox();
  await page.mouse.move(x + 40, y, { steps: 3 });
  await page.mouse.up();
  await expect(figure.locator('.hint b')).not.toHaveText('sphere, t = 4');
  await page.waitForTimeout(300); // The address would change only after a pause.
  expect(page.url()).toBe(address);
});

for (const [name, seen] of Object.entries({
  step01_rays: 'V = (', step01_program: 'floor, t = ', step02_sphere: 'sphere, t = ', step03_nearest: 'salmon, t = ', step04_diffuse: 'salmon, t = ', step05_phong: 'salmon, t = ', way_back: 'salmon, t = ',
})) {
  test(`${name}.html: the first picture says what the ray of a pixel meets`, async ({ page, home }) => {
    await open(page, `${home}${name}.html`);
    const preview = page.locator('figure[data-preview]');
    const { x, y, width } = await preview.locator('img').boundingBox();
    // In "Step 1: the program", the sky fills the upper half of the picture, so click on the lower
    // half. This click comes before the figure is ready. Once the figure is ready, it repeats the
    // press.
    await page.mouse.click(x + 0.58 * width, y + (name === 'step01_program' ? 0.5 : 0.3) * width);
    await expect(preview.locator('.hint b')).toContainText(seen, { timeout: 20_000 });
    await expect(preview.locator('.hint')).toBeInViewport();
    const words = await preview.locator('.handle-probe').getAttribute('aria-valuetext');
    const [, i, j] = words.match(/^column (\d+), row (\d+)/).map(Number);
    const bytes = (await preview.locator('.hint').textContent()).match(/\((\d+), (\d+), (\d+)\)(?!.*\()/).slice(1).map(Number);
    const shown = await preview.locator('img').evaluate((element, [i, j]) => {
      const context = Object.assign(document.createElement('canvas'), { width: 640, height: 360 }).getContext('2d');
      context.drawImage(element, 0, 0);
      return [...context.getImageData(i, j, 1, 1).data].slice(0, 3);
    }, [i, j]);
    expect(bytes, 'the colour of that pixel').toEqual(shown);
    const sum = preview.getByRole('link', { name: 'The whole sum' });
    if (/step01|way_back/.test(name)) return expect(sum).toHaveCount(0);
    await sum.click();
    await expect(page.locator('[data-panel]')).toBeVisible({ timeout: 20_000 });
    await expect(page.locator(`[data-panel] [data-number="${name}:i"]`)).toHaveText(String(i));
    await expect(page).toHaveURL(new RegExp(`#pixel=${i},${j}$`));
  });
}

test('the controls stay in their places when a picture is first touched', async ({ page, home }) => {
  await open(page, `${home}step05_phong.html`);
  const figure = page.locator('figure[data-live="step05_phong"]');
  await makeReady(figure);
  const places = () => figure.locator('.controls > :is(.switch, .range, .exact, .reset)').evaluateAll(all => {
    // The content above the figure may still change in height, so measure from the figure's top.
    const top = all[0].closest('figure').getBoundingClientRect().top;
    return all.filter(element => !element.hidden).map(element => [element.offsetLeft, Math.round(element.getBoundingClientRect().top - top), element.offsetWidth]);
  });
  const before = await places();
  await figure.locator('.handle-probe').click();
  await expect(figure).toHaveAttribute('data-touched');
  expect(await places()).toEqual(before);
});

test('the keyboard can choose a pixel of the first picture', async ({ page, home }) => {
  await open(page, `${home}step05_phong.html`);
  const preview = page.locator('figure[data-preview]');
  await preview.focus();
  await expect(preview.locator('.handle-probe')).toBeFocused({ timeout: 20_000 });
  await page.keyboard.press('ArrowLeft');
  await expect(preview.locator('.hint b')).toHaveText(/^salmon, t = /);
  await expect(page).toHaveURL(/#pixel=469,120$/);
});

test('on a phone, the picture stays in view while the reader scrolls through the panel', async ({ page, home }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, `${home}step05_phong.html`);
  const [figure, panel] = [page.locator('figure[data-live="step05_phong"]'), page.locator('[data-panel]')];
  await makeReady(figure);
  const stage = figure.locator('.stage');
  await stage.evaluate(element => element.scrollIntoView({ block: 'center' }));
  const { x, y } = await stage.boundingBox();
  await page.mouse.click(x + 100, y + 100);
  await expect(panel).toHaveAttribute('open');
  expect((await stage.boundingBox()).y).toBeCloseTo(y, 0);
  await panel.evaluate(element => element.scrollIntoView({ block: 'end' }));
  await expect(stage).toBeInViewport({ ratio: 1 });
});
