// Every figure first looks as printed, changes with its handles and controls, and is restored by
// Reset.
import { figures } from './book.js';
import { expect, open, readPixels, test } from './fixtures.js';

for (const [name, figure, k] of figures) {
  test(`${name}: the figure ${figure}, number ${k + 1} there, is interactive`, { tag: k ? '@thorough' : [] }, async ({ page, home }) => {
    await open(page, home + name);
    page.on('dialog', dialog => dialog.accept()); // The reader's own scene asks before it is wiped.
    const root = page.locator('figure[data-live]').nth(k);
    await root.scrollIntoViewIfNeeded();
    await root.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });

    // Describes everything that is drawn, and the positions of the handles.
    const look = async () => {
      await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
      const pictures = await root.locator('.stage > :is(img, canvas)').all();
      const shapes = await root.locator('svg *, .handle').evaluateAll(all => all.map(one =>
        [one.tagName, one.textContent, ...['d', 'cx', 'cy', 'r', 'x', 'y', 'style'].map(key => one.getAttribute(key))]));
      return JSON.stringify([shapes, await Promise.all(pictures.map(readPixels))]);
    };
    const printed = await look();
    const reset = root.locator('.reset');
    const expectReset = async gesture => {
      await reset.evaluate(one => { one.disabled = false; one.click(); });
      expect.soft(await look() === printed, `Reset after ${gesture} shows the figure as printed`).toBe(true);
    };
    await expectReset('nothing');
    const expectChange = async gesture => {
      expect.soft(await look() !== printed, `${gesture} changes it`).toBe(true);
      await expectReset(gesture);
    };

    const handles = await root.locator('.handle:visible').all();
    for (const handle of handles) {
      await handle.hover();
      const { x, y } = await handle.boundingBox();
      await page.mouse.down();
      await page.mouse.move(x + 25, y - 15, { steps: 3 });
      await page.mouse.up();
      const words = await handle.getAttribute('aria-label');
      await expectChange(`dragging ${words}`);
      if (handle !== handles[0]) continue;
      await handle.focus();
      await page.keyboard.press('ArrowLeft');
      await expectChange(`a key on ${words}`);
    }
    const controls = await root.locator('.controls [data-parameter] input:visible').all();
    // The reader's own scene has 19 controls, most of them alike, so 12 are usually enough.
    for (const control of controls.slice(0, process.env.THOROUGH ? undefined : 12)) {
      await control.focus();
      await page.keyboard.press(await control.evaluate(({ type, value, min }) => ({
        checkbox: 'Space', range: value === min ? 'End' : 'Home', text: value === min ? 'ArrowUp' : 'ArrowDown',
      })[type]));
      await expectChange(`a key on ${await control.locator('..').textContent()}`);
    }
    expect(handles.length + controls.length, 'handles and controls that were tried').toBeGreaterThan(0);
  });
}
