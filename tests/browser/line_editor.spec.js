// When a reader edits a line in a listing, the resulting picture is drawn, and the book's line can
// be restored.
import { expect, open, readPixels, test } from './fixtures.js';

const STEP = 'step04_diffuse';
const NORMAL = '(p - sphere.centre) / sphere.radius';

// Opens the page, and scrolls the line that computes the normal into view. Returns the line, its
// listing, and the listing's status.
async function prepare(page, home, hash = '') {
  await open(page, `${home}${STEP}.html${hash}`);
  const line = page.locator('[data-line=normal]');
  // Playwright's own scrolling first waits for the element to stop moving. Meanwhile, the syntax
  // highlighting may replace the element. So call the browser's `scrollIntoView` instead.
  await line.evaluate(element => element.scrollIntoView({ block: 'center' }));
  const listing = page.locator('.with-margin', { has: line });
  await listing.locator('code.hljs').or(listing.locator('canvas')).first().waitFor();
  return { line, listing, status: listing.getByRole('status') };
}

test('an edit is drawn, a mistake is marked, Escape closes the panel, and Undo restores each earlier text', async ({ page, home, source }) => {
  const { line, listing, status } = await prepare(page, home);
  await line.focus();
  await page.keyboard.press('Enter');
  await expect(status).toContainText('sphere.centre');
  if (source === 'server') { // A page opened from a folder can't read pixels.
    const printed = page.locator(`main img[src$="${STEP}.png"]`).first();
    expect(await readPixels(listing.locator('canvas')) === await readPixels(printed), 'the book’s line draws its picture').toBe(true);
  }
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.type(`${NORMAL} * 1.0`);
  await expect(status).toHaveText('Not one pixel differs from the book\'s picture.');
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.type('p - sphere.centre');
  await expect(status).toHaveText(/A known mistake gives the same pixels: n is not a unit vector/);
  await expect(page).toHaveURL(/#line=normal%3Ap\+-\+sphere\.centre$/);
  await expect(listing.locator('canvas')).toBeInViewport();
  await page.keyboard.type(' * 2');
  await expect(status).toContainText('Write 2.0');
  await expect(line).toHaveAttribute('aria-invalid', 'true');
  expect(await page.evaluate(() => CSS.highlights.has('wrong'))).toBe(true);
  await listing.getByRole('button', { name: 'Reset' }).click();
  await expect(line).toHaveText(NORMAL);
  expect(await page.evaluate(() => CSS.highlights.has('wrong'))).toBe(false);
  await page.keyboard.type('x');
  await page.keyboard.press('Escape');
  await expect(line).toHaveText(`x${NORMAL}`);
  await expect(line).toBeFocused();
  await expect(listing.locator('canvas')).toHaveCount(0);
  expect(page.url()).toContain('#line=normal%3Ax');
  for (const text of [NORMAL, 'p - sphere.centre * 2']) {
    await page.keyboard.press('ControlOrMeta+Z');
    await expect(line).toHaveText(text);
  }
  await expect(status).toHaveText(/^Undone in surface_point.rs. Write 2.0/);
  await page.keyboard.press('Control+Y');
  await expect(line).toHaveText(NORMAL);
  await expect(status).toHaveText(/^Redone in surface_point.rs. This is the book’s line/);
  await listing.getByRole('button', { name: 'Redo' }).click();
  await expect(line).toHaveText(`x${NORMAL}`);
  await listing.getByRole('button', { name: 'Close' }).click();
  await expect(listing.locator('canvas')).toHaveCount(0);
  await expect(page.locator('html')).toHaveCSS('scroll-padding-bottom', 'auto');
});

test('edited lines from an address, and edited lines that lose the focus, stay in the picture, the address and the history', async ({ page, home }) => {
  const copied = [];
  await page.exposeFunction('keep', text => { copied.push(text); });
  await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: { writeText: text => window.keep(text) } }));
  const { line } = await prepare(page, home, '#line=normal%3Ap%20%2A%200.3&line=attenuation%3A%281.0');
  const other = page.locator('[data-line=attenuation]');
  const status = page.getByRole('status').filter({ visible: true }).last();
  await expect(status).toHaveText('In another line of yours: The bracket that closes this one is missing.');
  await expect(line).toBeInViewport();
  // The code around the edited lines is coloured.
  const code = page.locator('code', { has: line });
  expect(await code.locator('span[class^=hljs]').count()).toBeGreaterThan(10);
  await other.click();
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.type('1.0');
  await expect(page).toHaveURL(/#line=attenuation%3A1\.0&line=normal%3Ap\+\*\+0\.3$/);
  await expect(line).toHaveText('p * 0.3');
  await expect(status).toHaveText(/Drawn/);
  const listing = page.locator('.with-margin', { has: other });
  for (const name of [/^Copy step04/, 'Copy line', 'Copy link']) await listing.getByRole('button', { name }).click();
  await expect.poll(() => copied.length).toBe(3);
  expect(copied[0]).toContain('self.a + self.b * d + self.c * d * d');
  expect(copied.slice(1)).toEqual(['1.0', page.url()]);
  await other.focus();
  await page.keyboard.press('ControlOrMeta+Z');
  await expect(other).toHaveText('(1.0');
  await line.click(); // This line is in a different listing, so Undo has to jump back.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(listing.locator('canvas')).toBeInViewport();
});

for (const [width, height] of [[1440, 900], [1280, 720], [1000, 720], [390, 844]]) {
  test(`the panel has one height, and does not move the line, at ${width}×${height}`, async ({ page, home }) => {
    await page.setViewportSize({ width, height });
    const { line, listing, status } = await prepare(page, home);
    await line.evaluate(element => element.scrollIntoView({ block: 'center' }));
    const place = async () => (await line.boundingBox()).y;
    const before = await place();
    await line.click();
    await expect(status).toContainText('sphere.centre');
    const panel = listing.locator('.panel');
    const panelHeight = async () => (await panel.boundingBox()).height;
    const first = await panelHeight();
    for (const text of ['p.nosuch()', '1', 'p * 0.5']) {
      await page.keyboard.press('ControlOrMeta+A');
      await page.keyboard.type(text);
      await expect(status).toHaveText(/isn't known here|Write 1.0|Drawn/);
      expect(await panelHeight(), text).toBe(first);
      expect(await place() - before, text).toBeCloseTo(0, 0);
    }
    const [code, box] = [await listing.locator('pre').boundingBox(), await panel.boundingBox()];
    if (width < 1100) return expect(await place() + 20).toBeLessThan(box.y);
    expect(box.x).toBeGreaterThan(code.x + code.width);
    expect(box.y + box.height).toBeLessThanOrEqual(height);
    // The panel covers no note.
    for (const note of await page.locator('main .note').all()) {
      const { x, y, width, height } = await note.boundingBox() ?? box;
      const isBeside = x + width <= box.x || y + height <= box.y || box.y + box.height <= y;
      expect.soft(isBeside, await note.textContent()).toBe(true);
    }
  });
}

test('a line does not move when it is clicked and the panel comes from a listing above', async ({ page, home }) => {
  const { line } = await prepare(page, home);
  const other = page.locator('[data-line=attenuation]');
  await line.click();
  await other.evaluate(element => element.scrollIntoView({ block: 'center' }));
  await page.waitForTimeout(500); // Wait until parts that have come near the view are laid out.
  const place = async () => (await other.boundingBox()).y;
  const before = await place();
  await other.click();
  await expect(page.locator('.with-margin', { has: other }).locator('.panel')).toBeVisible();
  await page.waitForTimeout(500);
  expect(Math.abs(await place() - before)).toBeLessThan(2);
});

test('the first editable line says that it can be edited, until the reader clicks a line, and each line has a name', async ({ page, home }) => {
  const { line } = await prepare(page, home);
  const mark = () => page.locator('[data-line]').first().evaluate(element => getComputedStyle(element, '::after').content);
  expect(await mark()).toContain('edit');
  await expect(line).toHaveAttribute('aria-label', 'The value of normal');
  await line.click();
  expect(await mark()).toBe('none');
});

for (const [width, height] of [[390, 508], [640, 400]]) {
  test(`line, message and picture are in view together at ${width}×${height}`, async ({ page, home }) => {
    await page.setViewportSize({ width, height });
    const { line, listing, status } = await prepare(page, home);
    await line.evaluate(element => element.scrollIntoView({ block: 'end' }));
    await line.click();
    await page.keyboard.press('Home');
    await page.keyboard.type('p.nosuch() + ');
    await expect(status).toContainText('.nosuch isn\'t known here');
    const panel = await listing.locator('.panel').boundingBox();
    const { y, height: lineHeight } = await line.boundingBox();
    expect(y).toBeGreaterThan(40);
    expect(y + lineHeight).toBeLessThanOrEqual(panel.y);
    for (const part of [status, listing.locator('canvas')]) await expect(part).toBeInViewport({ ratio: 0.9 });
  });
}

test('when the on-screen keyboard covers half of a phone, the edited line stays above the panel', async ({ page, home }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const { line, listing, status } = await prepare(page, home);
  await line.evaluate(element => element.scrollIntoView({ block: 'center' }));
  await line.click();
  await expect(status).toContainText('sphere.centre');
  await page.setViewportSize({ width: 390, height: 508 });
  await expect(async () => {
    const [{ y, height }, panel] = [await line.boundingBox(), await listing.locator('.panel').boundingBox()];
    expect(y + height).toBeLessThanOrEqual(panel.y);
    expect(panel.y + panel.height).toBeCloseTo(508, 0);
  }).toPass({ timeout: 5000 });
});

test('a link with a control character, or with more edits than there are editable lines, changes nothing', async ({ page, home }) => {
  const hashes = {
    'control character': '#line=normal:p%20%1Fattenuation%201.0',
    'edits, but this page has only': `#${Array(1000).fill('line=normal:p').join('&')}`,
  };
  for (const [words, hash] of Object.entries(hashes)) {
    await page.goto('about:blank');
    const { line, status } = await prepare(page, home, hash);
    await expect(status).toContainText(words);
    await expect(line).toHaveText(NORMAL);
    await expect(page).not.toHaveURL(/#line/);
  }
});

test('if an edited expression has several rows, their indentation is not underlined, even after an edit', async ({ page, home }) => {
  await open(page, `${home}step05_phong.html`);
  const line = page.locator('[data-line=specular]');
  const indents = line.locator('.indent');
  await expect(indents).toHaveCount(2);
  expect(await indents.allTextContents()).toEqual(['        ', '        ']);
  await line.evaluate(element => element.scrollIntoView({ block: 'center' }));
  await page.locator('.with-margin', { has: line }).locator('code.hljs').waitFor();
  await line.focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('End');
  await page.keyboard.type(' * 0.5');
  await page.keyboard.press('Escape');
  await expect(line).toContainText(' * 0.5');
  await expect(indents).toHaveCount(2);
  await expect(indents.first()).toHaveCSS('display', 'inline-block');
});
