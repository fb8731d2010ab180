// Handles and controls change a figure. Reset restores the figure's initial look.
import { figures } from './book.js';
import { expect, makeReady, open, readPixels, test } from './fixtures.js';

test('Home and End move a handle as far as it goes, without an error message', async ({ page, home }) => {
  await open(page, `${home}step01_rays.html`);
  const figure = page.locator('#figure-ray');
  await makeReady(figure);
  const handle = figure.getByRole('slider', { name: 'the start S' });
  await handle.focus();
  const position = () => handle.evaluate(element => Number(element.getAttribute('aria-valuenow')));
  await expect(figure.locator('[data-parameter=the-start-S-x] [type=text]')).not.toHaveAttribute('inputmode');
  const [first, refused] = [await position(), figure.locator('.refused')];
  // End moves S as far as possible, but not to the maximum of 7, because the ray's tip reaches the
  // figure's border first.
  for (const [key, is] of [['Home', x => x === -2], ['End', x => first < x && x < 7]]) {
    await page.keyboard.press(key);
    expect(is(await position()), `${key} goes to ${await position()}`).toBe(true);
    await page.keyboard.press(key === 'Home' ? 'ArrowLeft' : 'ArrowRight');
    await expect(refused).toBeEmpty();
  }
});

test('a typed number that a figure cannot use is explained', async ({ page, home }) => {
  await open(page, `${home}step04_diffuse.html`);
  const figure = page.locator('#figure-attenuation');
  await makeReady(figure);
  const field = figure.getByRole('textbox', { name: 'c of your curve' });
  // A phone's keypad for decimal numbers has no minus, so a field asks for this keypad only if its
  // number can't be negative.
  await expect(field).toHaveAttribute('inputmode', 'decimal');
  for (const [text, words] of [['-5', 'The figure shows 0 instead.'], ['0.1', '']]) {
    await field.fill(text);
    await expect(figure.locator('.refused')).toHaveText(words);
  }
  // If a finger that scrolls the page touches a slider, the slider keeps its value.
  const slider = figure.getByRole('slider', { name: 'a of your curve' });
  const value = await slider.inputValue();
  await slider.dispatchEvent('pointerdown');
  await slider.fill('2');
  await slider.dispatchEvent('pointercancel');
  await expect(slider).toHaveValue(value);
});

test('labels of drawings do not overlap at the limit of any control, and no handle covers a label', async ({ page, home }) => {
  // On a phone, labels take up more of a drawing, because they shrink less than the drawing does.
  await page.setViewportSize({ width: 390, height: 844 });
  for (const name of new Set(figures.map(([name]) => name))) {
    await open(page, home + name);
    await page.evaluate(() => document.querySelectorAll('details').forEach(box => { box.open = true; }));
    for (const figure of await page.locator('.drawing[data-live]').all()) {
      await makeReady(figure);
    }
    const faults = await page.evaluate(async () => {
      await document.fonts.ready;
      const overlap = (box, other) => box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
      const findFaults = svg => {
        const { a: scale, e, f } = svg.getScreenCTM();
        const labels = [...svg.querySelectorAll('text')].filter(element => element.textContent).map(element => {
          const { x, width } = element.getBBox();
          const [baseline, size] = [Number(element.getAttribute('y')), parseFloat(getComputedStyle(element).fontSize)];
          const [left, right] = [x, x + width].map(x => scale * x + e);
          const [top, bottom] = [baseline - 0.7 * size, baseline + 0.2 * size].map(y => scale * y + f);
          return { words: element.textContent, left, right, top, bottom };
        });
        const box = svg.getBoundingClientRect();
        const cut = labels.filter(label => label.left < box.left || label.top < box.top || label.right > box.right || label.bottom > box.bottom);
        const boxes = selector => [...svg.parentElement.querySelectorAll(selector)].map(element => element.getBoundingClientRect());
        const [handles, cues] = [boxes('.handle:not([hidden])'), boxes('.cue')];
        // A handle is a disc. It covers a label if the distance from the disc's centre to the
        // nearest point of the label is less than the disc's radius.
        const isBelow = ({ left, right, top, bottom }, { x, y, width }) => {
          const [centreX, centreY] = [x + width / 2, y + width / 2];
          const [nearX, nearY] = [Math.max(left, Math.min(centreX, right)), Math.max(top, Math.min(centreY, bottom))];
          return Math.hypot(nearX - centreX, nearY - centreY) < width / 2;
        };
        const isCovered = label => handles.some(handle => isBelow(label, handle)) || cues.some(cue => overlap(label, cue));
        const over = labels.filter((label, k) => isCovered(label) || labels.slice(0, k).some(other => overlap(label, other)));
        return [...cut, ...over].map(label => label.words);
      };
      const faults = [];
      for (const figure of document.querySelectorAll('.drawing[data-live]')) {
        const note = gesture => faults.push(...findFaults(figure.querySelector('svg')).map(words => `${figure.id}, ${gesture}: ${words}`));
        note('as printed');
        const reset = () => figure.querySelector('.reset').click();
        for (const handle of figure.querySelectorAll('.handle')) {
          for (const [key, times] of [['Home', 1], ['End', 1], ['ArrowUp', 30], ['ArrowDown', 30]]) {
            for (let k = 0; k < times; k++) handle.dispatchEvent(new KeyboardEvent('keydown', { key, shiftKey: times > 1, bubbles: true }));
            note(`${key} on ${handle.ariaLabel}`);
            reset();
          }
        }
        for (const slider of figure.querySelectorAll('input[type=range]')) {
          for (const end of ['min', 'max']) {
            slider.value = slider[end];
            slider.dispatchEvent(new InputEvent('input'));
            await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
            note(`${end} of ${slider.closest('[data-parameter]').dataset.parameter}`);
            reset();
          }
        }
      }
      return faults;
    });
    expect.soft(faults, name).toEqual([]);
  }
});

for (const [name, figure, k] of figures) {
  test(`${name}: the figure ${figure}, figure ${k + 1} of the page, is interactive`, { tag: k ? '@thorough' : [] }, async ({ page, home }) => {
    await open(page, home + name);
    // On "A scene of your own", Reset asks for confirmation.
    page.on('dialog', dialog => dialog.accept());
    const root = page.locator('figure[data-live]').nth(k);
    await makeReady(root);

    // Describes everything that is drawn, and the positions of the handles.
    const look = async () => {
      await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
      const pictures = await root.locator('.stage > :is(img, canvas)').all();
      const shapes = await root.locator('svg *, .handle').evaluateAll(all => all.map(element =>
        [element.tagName, element.textContent, ...['d', 'cx', 'cy', 'r', 'x', 'y', 'style'].map(key => element.getAttribute(key))]));
      return JSON.stringify([shapes, await Promise.all(pictures.map(readPixels))]);
    };
    const printed = await look();
    const reset = root.locator('.reset');
    const expectReset = async gesture => {
      await reset.evaluate(element => { element.disabled = false; element.click(); });
      expect.soft(await look() === printed, `Reset after ${gesture} shows the figure as printed`).toBe(true);
    };
    await expectReset('nothing');
    const expectChange = async gesture => {
      expect.soft(await look() !== printed, `${gesture} changes the figure`).toBe(true);
      await expectReset(gesture);
    };

    const handles = await root.locator('.handle:visible').all();
    for (const handle of handles) {
      await handle.hover();
      const { x, y } = await handle.boundingBox();
      await page.mouse.down();
      await page.mouse.move(x + 30, y - 20, { steps: 3 });
      await page.mouse.up();
      const words = await handle.getAttribute('aria-label');
      await expectChange(`dragging ${words}`);
      if (handle !== handles[0]) continue;
      await handle.focus();
      await page.keyboard.press('ArrowLeft');
      await expectChange(`a key on ${words}`);
    }
    const controls = await root.locator('.controls [data-parameter] input:visible').all();
    // In a figure with many controls, most controls are alike. So test only the first 12 controls,
    // unless THOROUGH=1 is set.
    for (const control of controls.slice(0, process.env.THOROUGH ? undefined : 12)) {
      await control.focus();
      await page.keyboard.press(await control.evaluate(element => {
        const isAtMin = element.value === element.closest('[data-parameter]').querySelector('[type=range]')?.min;
        return { checkbox: 'Space', range: isAtMin ? 'End' : 'Home', text: isAtMin ? 'ArrowUp' : 'ArrowDown' }[element.type];
      }));
      await expectChange(`a key on ${await control.getAttribute('aria-label') ?? await control.locator('..').textContent()}`);
    }
    expect(handles.length + controls.length, 'handles and controls that were tried').toBeGreaterThan(0);
  });
}
