// Every page shows its pictures and fits its window, and is accessible as far as axe can tell.
import AxeBuilder from '@axe-core/playwright';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chapters, pages } from './book.js';
import { expect, open, test } from './fixtures.js';

// Opens a page, opens all folded boxes on the page, and lays out even the parts far below the
// window.
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
      pictures.forEach(element => { element.loading = 'eager'; });
      await Promise.all(pictures.map(element => element.decode().catch(() => {})));
      const missing = pictures.filter(element => element.naturalWidth === 0).map(element => element.src);
      return [root.scrollWidth - root.clientWidth, missing];
    });
    expect.soft(sideways, 'pixels by which the page scrolls sideways').toBeLessThanOrEqual(1);
    expect.soft(missing, 'pictures that do not load').toEqual([]);
  });
}

test('on a phone, a shadow at the edge marks what can be scrolled sideways', async ({ page, home }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openAll(page, `${home}step01_rays.html`);
  const scrolling = await page.locator('main *').evaluateAll(all => all
    .filter(element => element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).overflowX === 'auto')
    .map(element => [element.parentElement.className, getComputedStyle(element).backgroundAttachment.includes('local')]));
  expect(scrolling.filter(([, hasShadow]) => !hasShadow)).toEqual([]);
  expect(scrolling.length).toBeGreaterThan(10);
});

test('the section that is being read is marked in the contents', async ({ page, home }) => {
  await page.setViewportSize({ width: 1440, height: 720 });
  await open(page, `${home}step02_sphere.html`);
  const marked = page.locator('#contents [aria-current=location]');
  await expect(marked).toHaveCount(0);
  const links = await page.locator('#contents .here a').all();
  for (const link of [links.at(-1), links[2]]) {
    await link.click();
    await expect(marked).toHaveText(await link.textContent());
    await expect(marked).toBeInViewport({ ratio: 1 });
  }
  await page.setViewportSize({ width: 390, height: 500 });
  await page.locator('#contents-toggle').dispatchEvent('click');
  await expect(marked).toBeInViewport({ ratio: 1 });
  await page.evaluate(() => scrollTo(0, 0));
  await expect(marked).toHaveCount(0);
});

test('a screen reader finds the controls of figures from the start, and each figure has a name', async ({ page, home, browserName }) => {
  test.skip(browserName !== 'chromium', 'only Chromium shows its tree to a test');
  await openAll(page, `${home}step05_phong.html`);
  const tools = await page.context().newCDPSession(page);
  const { nodes } = await tools.send('Accessibility.getFullAXTree');
  const names = role => nodes.filter(node => !node.ignored && node.role.value === role).map(node => node.name.value);
  expect(names('slider')).toContain('n of the salmon sphere');
  expect(names('figure')).not.toContain('');
  expect(names('figure')).toContainEqual(expect.stringMatching(/phong\.rs/));
});

test('commands are copied without the prompt and the output', async ({ page, home, browserName }) => {
  test.skip(browserName !== 'chromium', 'only Chromium has a clipboard that a test can read');
  await open(page, `${home}step01_program.html`);
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const console = page.locator('.console', { hasText: 'cinerama' });
  await console.getByRole('button', { name: 'Copy the command' }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
    'cargo run -p step01_rays -- --fov 120 --output wide.png\n'
    + 'cargo run -p step01_rays -- --aspect 2.59:1 --output cinerama.png');
});

test('the copied parts of a file, pasted one below the other, make up the file', async ({ page, home, browserName }) => {
  test.skip(browserName !== 'chromium', 'only Chromium has a clipboard that a test can read');
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const parts = [];
  for (const name of ['step01_rays', 'step01_program']) {
    await open(page, `${home}${name}.html`);
    for (const button of await page.getByRole('button', { name: 'Copy step01_rays/src/lib.rs' }).all()) {
      await button.click();
      await expect(button).toHaveText('Copied');
      parts.push(await page.evaluate(() => navigator.clipboard.readText()));
    }
  }
  expect(parts.length).toBeGreaterThan(2);
  const file = join(import.meta.dirname, '../../steps/step01_rays/src/lib.rs');
  expect(parts.join('')).toBe(readFileSync(file, 'utf8'));
  // An editor that formats a file drops blank lines at the end of the file, so no copied part may
  // end with a blank line.
  expect(parts.filter(part => part.endsWith('\n\n'))).toEqual([]);
});

// axe checks these pages only with THOROUGH=1, because they consist of the same kinds of parts as
// other pages, such as step 4's.
const THOROUGH_PAGES = /^(step0[1235]|way_back|mistakes)/;

for (const name of chapters) {
  test(`${name} is accessible`, { tag: THOROUGH_PAGES.test(name) ? '@thorough' : [] }, async ({ page, home, browserName }) => {
    test.skip(browserName !== 'chromium', 'axe finds the same in all browsers');
    await openAll(page, home + name);
    // Colours and width rarely make a difference, so one combination is enough without THOROUGH=1.
    for (const [width, colorScheme] of process.env.THOROUGH ? [[1280, 'light'], [390, 'dark']] : [[1280, 'light']]) {
      await page.setViewportSize({ width, height: 900 });
      await page.emulateMedia({ colorScheme });
      // axe doesn't know MathML. It checks each letter of a formula on its own, and thinks that a
      // table header is empty if the header consists of a formula.
      const axe = new AxeBuilder({ page }).options({ preload: false, rules: { 'empty-table-header': { enabled: false } } }).exclude('math');
      const { violations } = await axe.analyze();
      const faults = violations.map(({ id, help, nodes }) => `${id}: ${help}, at ${nodes[0].target}`);
      expect.soft(faults, colorScheme).toEqual([]);
    }
  });
}
