// Everybody can use every page, as far as axe can tell.
import AxeBuilder from '@axe-core/playwright';
import { chapters } from './book.js';
import { expect, open, test } from './fixtures.js';

for (const name of chapters) {
  test(`${name} is accessible`, async ({ page, home, colorScheme, viewport }) => {
    await open(page, home + name);
    await page.evaluate(() => {
      document.querySelectorAll('details').forEach(box => { box.open = true; });
      document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; });
    });
    const axe = new AxeBuilder({ page }).options({ preload: false });
    // Nothing but colours depends on dark, and little on the width.
    if (colorScheme === 'dark') axe.withRules(['color-contrast']);
    else if (viewport.width < 1280) axe.withRules(['scrollable-region-focusable', 'target-size']);
    const { violations } = await axe.analyze();
    const told = violations.map(({ id, help, nodes }) => `${id}: ${help}, at ${nodes[0].target}`);
    expect(told).toEqual([]);
  });
}
