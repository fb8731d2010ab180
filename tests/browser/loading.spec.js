// Pages tell what they can't do, and work in places that are strange.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, open, test } from './fixtures.js';

const name = 'step01_rays.html';

// The first figure of a page, in view.
async function findFigure(page, address) {
  await open(page, address);
  const figure = page.locator('figure[data-live]').first();
  await figure.scrollIntoViewIfNeeded();
  return figure;
}

test('a module that fails to load is loaded again', async ({ browser, home }) => {
  // A page of its own: here the browser has to complain of the first load.
  const page = await browser.newPage();
  let loads = 0;
  await page.route('**/live-module.js', route => {
    loads += 1;
    return loads === 1 ? route.abort() : route.continue();
  });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/did not load/);
  await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
  await expect(figure.locator('.refused')).toBeEmpty();
  expect(loads).toBe(2);
  await page.close();
});

test('without WebAssembly a figure says what is missing', async ({ page, home }) => {
  await page.addInitScript(() => { delete window.WebAssembly; });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/no WebAssembly/);
});

test('under Trusted Types figures, colours and the search work', async ({ page, home }) => {
  await page.route('**/*.html', async route => {
    const response = await route.fetch();
    const headers = response.headers();
    headers['content-security-policy'] += `; require-trusted-types-for 'script'`;
    await route.fulfill({ response, headers });
  });
  const figure = await findFigure(page, home + name);
  await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
  await page.locator('code.language-rust').first().scrollIntoViewIfNeeded();
  await expect(page.locator('code.language-rust').first()).toHaveClass(/hljs/);
  await page.keyboard.press('s');
  await page.locator('#search-field').fill('sphere');
  await expect(page.locator('#search-results a').first()).toBeVisible();
});

test('an address without .html marks its page and lists its sections', async ({ page, home }) => {
  await page.route(home + name.replace('.html', ''), async route => route.fulfill({ response: await route.fetch({ url: home + name }) }));
  await open(page, home + name.replace('.html', ''));
  await expect(page.locator('#contents a[aria-current=page]')).toHaveAttribute('href', name);
  expect(await page.locator('#contents .here li').count()).toBeGreaterThan(3);
});

test('paper is light, and forced colours keep the cross', async ({ page, home }) => {
  await page.addInitScript(() => localStorage.setItem('theme', 'dark'));
  await page.emulateMedia({ media: 'print' });
  await open(page, `${home}step03_nearest.html`);
  expect(await page.evaluate(() => getComputedStyle(document.querySelector('h1')).color)).toBe('rgb(35, 33, 30)');
  await page.emulateMedia({ media: 'screen', forcedColors: 'active' });
  await page.locator('figure[data-live="step03_nearest"]').scrollIntoViewIfNeeded();
  const cross = page.locator('.handle-probe').first();
  await expect(cross).toBeVisible({ timeout: 20_000 });
  expect(await cross.evaluate(one => getComputedStyle(one).backgroundImage)).toContain('gradient');
});

test('a prompt is not copied, and code is not translated', async ({ page, home }) => {
  await open(page, home + name);
  const copied = await page.locator('.console code').first().evaluate(code => {
    getSelection().selectAllChildren(code);
    const clipboardData = new DataTransfer();
    code.dispatchEvent(new ClipboardEvent('copy', { clipboardData, bubbles: true, cancelable: true }));
    return [code.textContent, clipboardData.getData('text/plain'), code.translate];
  });
  expect(copied[0]).toMatch(/^\$ cargo/);
  expect(copied[1]).toMatch(/^cargo/);
  expect(copied[2]).toBe(false);
});

test('parts of a file are copied as they stand in it', async ({ page, home }) => {
  await page.addInitScript(() => {
    globalThis.copied = '';
    Object.defineProperty(navigator, 'clipboard', { value: { writeText: async text => { copied += text; } } });
  });
  await open(page, `${home}step02_sphere.html`);
  for (const path of ['lib.rs', 'quadratic.rs']) {
    for (const button of await page.locator(`.listing[data-path$="src/${path}"] .copy`).all()) await button.click();
    const file = resolve(import.meta.dirname, '../../steps/step02_sphere/src', path);
    expect((await page.evaluate(() => copied))).toBe(readFileSync(file, 'utf8'));
    await page.evaluate(() => { copied = ''; });
  }
});
