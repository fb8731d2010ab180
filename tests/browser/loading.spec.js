// Pages tell what they can't do, and work in places that are strange.
import { expect, open, test } from './fixtures.js';

const name = 'step01_rays.html';

// The first figure of a page, in view.
async function findFigure(page, address) {
  await open(page, address);
  const figure = page.locator('figure[data-live]').first();
  await figure.scrollIntoViewIfNeeded();
  return figure;
}

test('a module and a search that fail to load are loaded again', async ({ browser, home }) => {
  // A page of its own: here the browser has to complain of the first load.
  const page = await browser.newPage();
  for (const file of ['live-module', 'search-index']) await page.route(`**/${file}.js`, route => route.abort(), { times: 1 });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/did not load/);
  await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
  await expect(figure.locator('.refused')).toBeEmpty();
  for (const words of [/did not load/, /sections$/]) {
    await page.keyboard.press('s');
    await page.keyboard.type('sphere');
    await expect(page.locator('#search-status')).toHaveText(words);
    await page.keyboard.press('Escape');
    // The field of the closed dialog has the focus for a frame more.
    await expect(page.locator('#search-field')).not.toBeFocused();
  }
});

test('without WebAssembly a figure says what is missing', async ({ page, home }) => {
  await page.addInitScript(() => { delete window.WebAssembly; });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/no WebAssembly/);
});

test('an address without .html marks its page', async ({ page, home }) => {
  const address = home + name.replace('.html', '');
  await page.route(address, async route => route.fulfill({ response: await route.fetch({ url: home + name }) }));
  await open(page, address);
  await expect(page.locator('#contents a[aria-current=page]')).toHaveAttribute('href', name);
});

test('paper is light, and forced colours keep the cross', async ({ page, home }) => {
  await page.addInitScript(() => localStorage.setItem('theme', 'dark'));
  await page.emulateMedia({ media: 'print' });
  await open(page, `${home}step03_nearest.html`);
  await expect(page.locator('h1')).toHaveCSS('color', 'rgb(35, 33, 30)');
  await page.emulateMedia({ media: 'screen', forcedColors: 'active' });
  await page.locator('figure[data-live="step03_nearest"]').scrollIntoViewIfNeeded();
  await expect(page.locator('.handle-probe').first()).toHaveCSS('background-image', /gradient/, { timeout: 20_000 });
});

test('a prompt is not copied', async ({ page, home }) => {
  await open(page, home + name);
  const copied = await page.locator('.console code').first().evaluate(code => {
    getSelection().selectAllChildren(code);
    return getSelection().toString();
  });
  expect(copied).toMatch(/^cargo/);
});
