// Everybody can use every page, as far as axe can tell.
import AxeBuilder from '@axe-core/playwright';
import { chapters } from './book.js';
import { expect, open, test } from './fixtures.js';

// The longest take ten seconds each, and are made of what is on the others, too.
const LONG = /^(step0[1235]_(rays|program|sphere|nearest|phong)|way_back|mistakes)\.html$/;

for (const name of chapters) {
  test(`${name} is accessible`, { tag: LONG.test(name) ? '@thorough' : [] }, async ({ page, home }) => {
    await open(page, home + name);
    await page.evaluate(() => {
      document.querySelectorAll('details').forEach(box => { box.open = true; });
      document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; });
    });
    const expectNoViolations = async (view, rules) => {
      // axe knows no MathML: it reads each letter of a formula, and sees no text in it.
      const axe = new AxeBuilder({ page }).options({ preload: false, rules: { 'empty-table-header': { enabled: false } } }).exclude('math');
      if (rules) axe.withRules(rules);
      const { violations } = await axe.analyze();
      const faults = violations.map(({ id, help, nodes }) => `${id}: ${help}, at ${nodes[0].target}`);
      expect.soft(faults, view).toEqual([]);
    };
    await expectNoViolations('wide and light');
    // Nothing but colours depends on dark, and little on the width.
    if (!process.env.THOROUGH) return;
    await page.emulateMedia({ colorScheme: 'dark' });
    await expectNoViolations('dark', ['color-contrast']);
    await page.setViewportSize({ width: 390, height: 900 });
    await expectNoViolations('narrow', ['scrollable-region-focusable', 'target-size']);
  });
}
