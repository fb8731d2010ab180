// A figure changes by its handles and controls; reset brings back what is printed.
import { figures } from './book.js';
import { expect, open, test } from './fixtures.js';

for (const [k, [name, figure, before]] of figures.entries()) {
  const place = before ? `, number ${before + 1} there,` : '';
  // One figure of a page will do.
  const isFirst = figures.findIndex(([other]) => other === name) === k;
  test(`${name}: the figure ${figure}${place} answers`, { tag: isFirst ? [] : '@thorough' }, async ({ page, home }) => {
    await open(page, home + name);
    page.on('dialog', dialog => dialog.accept()); // A scene of one's own is not wiped unasked.
    const root = page.locator(`figure[data-live="${figure}"]`).nth(before);
    await root.scrollIntoViewIfNeeded();
    await root.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });

    const drawing = async () => {
      await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
      return root.evaluate(one => one.querySelector('svg')?.innerHTML + JSON.stringify([
        ...[...one.querySelectorAll('canvas')].map(canvas => canvas.toDataURL()),
        ...[...one.querySelectorAll('.handle')].map(handle => handle.style.cssText)]));
    };
    const reset = root.locator('.reset');
    await reset.evaluate(one => { one.disabled = false; one.click(); }); // Now all is drawn.
    const printed = await drawing();
    let moved = 0;
    const expectChange = async gesture => {
      moved += 1;
      expect.soft(await drawing() !== printed, `${gesture} changes it`).toBe(true);
      if (await reset.isDisabled()) return;
      await reset.click();
      expect.soft(await drawing() === printed, `after ${gesture}, reset brings back what is printed`).toBe(true);
    };

    const handles = await root.locator('.handle:visible').all();
    for (const handle of handles) {
      await handle.hover();
      const { x, y } = await handle.boundingBox();
      await page.mouse.down();
      await page.mouse.move(x + 25, y - 15, { steps: 3 });
      await page.mouse.up();
      await expectChange(`dragging ${await handle.getAttribute('aria-label')}`);
    }
    // Number fields set the same values as ranges and handles: one of each figure will do.
    const others = await root.locator('.controls [data-parameter] input:not([type=text]):visible').all();
    const numbers = await root.locator('.controls [data-parameter] input[type=text]:visible').all();
    for (const control of [...others, ...numbers.slice(0, 1)]) {
      await control.focus();
      await page.keyboard.press(await control.evaluate(({ type, value, min }) => ({
        checkbox: 'Space', range: value === min ? 'End' : 'Home',
        text: value === min ? 'ArrowUp' : 'ArrowDown',
      })[type]));
      await expectChange(`a key on ${await control.locator('..').textContent()}`);
    }
    expect(moved, 'handles and controls that were tried').toBeGreaterThan(0);
  });
}
