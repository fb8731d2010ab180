// Every page shows all of itself, and everybody can use it, as far as axe can tell.
import AxeBuilder from '@axe-core/playwright';
import { chapters, pages } from './book.js';
import { expect, open, test } from './fixtures.js';

// Opens a page, what is folded on it, and lays out what is far below.
async function openAll(page, address) {
  await open(page, address);
  await page.evaluate(() => {
    document.querySelectorAll('details').forEach(box => { box.open = true; });
    document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; });
  });
}

for (const name of pages) {
  test(`${name} shows its pictures and does not scroll sideways`, async ({ page, home }) => {
    await openAll(page, home + name);
    const [sideways, missing] = await page.evaluate(async () => {
      const [root, pictures] = [document.documentElement, [...document.images]];
      pictures.forEach(one => { one.loading = 'eager'; });
      await Promise.all(pictures.map(one => one.decode().catch(() => {})));
      const missing = pictures.filter(one => one.naturalWidth === 0).map(one => one.src);
      return [root.scrollWidth - root.clientWidth, missing];
    });
    expect.soft(sideways, 'pixels that it scrolls sideways').toBeLessThanOrEqual(1);
    expect.soft(missing, 'pictures that do not load').toEqual([]);
  });
}

// They are made of what the pages of step 4 and the others have: axe looks at them by THOROUGH=1 alone.
const THOROUGH_PAGES = /^(step0[1235]|way_back|mistakes)/;

for (const name of chapters) {
  test(`${name} is accessible`, { tag: THOROUGH_PAGES.test(name) ? '@thorough' : [] }, async ({ page, home, browserName }) => {
    test.skip(browserName !== 'chromium', 'what axe looks at is the same in all browsers');
    await openAll(page, home + name);
    // Little depends on the colours, and on the width.
    for (const [width, colorScheme] of process.env.THOROUGH ? [[1280, 'light'], [390, 'dark']] : [[1280, 'light']]) {
      await page.setViewportSize({ width, height: 900 });
      await page.emulateMedia({ colorScheme });
      // axe knows no MathML: it reads each letter of a formula, and sees no text in it.
      const axe = new AxeBuilder({ page }).options({ preload: false, rules: { 'empty-table-header': { enabled: false } } }).exclude('math');
      const { violations } = await axe.analyze();
      const faults = violations.map(({ id, help, nodes }) => `${id}: ${help}, at ${nodes[0].target}`);
      expect.soft(faults, colorScheme).toEqual([]);
    }
  });
}
