// Pages report what doesn't work, and cope with unusual servers, addresses and media.
import { expect, open, test } from './fixtures.js';
import { chapters, picture } from './book.js';
import { POLICY, serve } from './server.js';

const name = 'step01_rays.html';

// Opens a page, and scrolls its first figure into view. Returns that figure.
async function findFigure(page, address) {
  await open(page, address);
  const figure = page.locator('figure[data-live]').first();
  await figure.scrollIntoViewIfNeeded();
  return figure;
}

test('a module and a search index that fail to load are loaded again', async ({ browser, home }) => {
  // Don't use the fixture's page, which makes the test fail if the browser reports an error. Here
  // the browser does report an error: the first attempt to load each file fails.
  const page = await browser.newPage();
  for (const file of ['live-module', 'search-index']) await page.route(`**/${file}.js`, route => route.abort(), { times: 1 });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/did not load/);
  await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
  await expect(figure.locator('.refused')).toBeEmpty();
  for (const words of [/did not load/, /\d sections/]) {
    await page.keyboard.press('s');
    await page.keyboard.type('sphere');
    await expect(page.locator('#search-status')).toHaveText(words);
    await page.keyboard.press('Escape');
    // The field keeps the focus for one frame after the dialog has closed.
    await expect(page.locator('#search-field')).not.toBeFocused();
  }
});

test('without WebAssembly a figure says what is missing', async ({ page, home }) => {
  await page.addInitScript(() => { delete window.WebAssembly; });
  const figure = await findFigure(page, home + name);
  await expect(figure.locator('.refused')).toHaveText(/no WebAssembly/);
});

for (const width of [390, 1440]) {
  test(`fonts that load late hardly move the text at ${width} pixels`, async ({ page, home, browserName }) => {
    test.skip(browserName !== 'chromium', 'only Chromium measures layout shifts');
    test.setTimeout(180_000);
    await page.setViewportSize({ width, height: 844 });
    await page.addInitScript(() => {
      window.shift = 0;
      new PerformanceObserver(list => list.getEntries().forEach(({ value }) => { window.shift += value; })).observe({ type: 'layout-shift', buffered: true });
    });
    // The font requests that are held back. Null while fonts load normally.
    let held = [];
    await page.route('**/*.woff2', route => held ? void held.push(route) : route.continue());
    const names = process.env.THOROUGH ? chapters : ['how.html', 'problems.html', 'step02_practice.html', 'way_back_practice.html'];
    for (const name of names) {
      held = [];
      // Don't wait for the page's load event, which comes only after the fonts.
      await page.goto(home + name, { waitUntil: 'domcontentloaded' });
      await page.locator('script[src$="search.js"]').waitFor({ state: 'attached' });
      const hasFallbacks = await page.evaluate(() => new FontFace('Fallback', 'local("DejaVu Math TeX Gyre"), local("DejaVuMathTeXGyre-Regular")').load().then(() => true, () => false));
      test.skip(!hasFallbacks, 'fonts.css scales the DejaVu fonts, and they are not installed');
      await page.evaluate(() => new Promise(done => { setTimeout(() => requestAnimationFrame(done), 300); }));
      expect(held.length).toBeGreaterThan(1);
      const late = held;
      held = null;
      await Promise.all(late.map(route => route.continue()));
      await page.evaluate(() => document.fonts.ready);
      await page.evaluate(() => new Promise(done => { setTimeout(() => requestAnimationFrame(done), 200); }));
      expect.soft(await page.evaluate(() => window.shift), name).toBeLessThan(0.05);
    }
  });
}

test('an address without .html marks its page in the contents', async ({ page, home }) => {
  const address = home + name.replace('.html', '');
  await page.route(address, async route => route.fulfill({ response: await route.fetch({ url: home + name }) }));
  await open(page, address);
  await expect(page.locator('#contents a[aria-current=page]')).toHaveAttribute('href', name);
});

test('a printed page is light, and forced colours do not hide the cross on a picture', async ({ page, home }) => {
  await page.addInitScript(() => localStorage.setItem('theme', 'dark'));
  await page.emulateMedia({ media: 'print' });
  await open(page, `${home}step03_nearest.html`);
  await expect(page.locator('h1')).toHaveCSS('color', 'rgb(35, 33, 30)');
  await page.emulateMedia({ media: 'screen', forcedColors: 'active' });
  await expect(page.locator('h1 > a')).toHaveCSS('color', await page.locator('main > p').first().evaluate(element => getComputedStyle(element).color));
  await page.locator('figure[data-live="step03_nearest"]').scrollIntoViewIfNeeded();
  await expect(page.locator('.handle-probe').first()).toHaveCSS('background-image', /gradient/, { timeout: 20_000 });
});

test('a copied selection of a command does not contain the prompt', async ({ page, home }) => {
  await open(page, home + name);
  const copied = await page.locator('.console code').first().evaluate(code => {
    getSelection().selectAllChildren(code);
    return getSelection().toString();
  });
  expect(copied).toMatch(/^cargo/);
});

// Runs a test on a page that is served with this policy. The browser may report errors under the
// policy. So this function makes its own page: the fixture's page would fail the test.
async function withPolicy(browser, policy, run) {
  const { server, address } = await serve(policy);
  const page = await browser.newPage();
  try {
    await run(page, address);
  } finally {
    await page.close();
    server.close();
    server.closeAllConnections();
  }
}

test('everything works under a policy without inline scripts', async ({ browser }) => {
  const policy = POLICY.replace(`'wasm-unsafe-eval' 'unsafe-inline'`, `'wasm-unsafe-eval'`);
  expect(policy).not.toBe(POLICY);
  await withPolicy(browser, policy, async (page, home) => {
    const figure = await findFigure(page, `${home}step04_diffuse.html`);
    await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
    await page.keyboard.press('s');
    await page.keyboard.type('normal');
    await expect(page.locator('#search-status')).toHaveText(/\d sections/);
    await page.keyboard.press('Escape');
    await page.locator('[data-line=normal]').click();
    await expect(page.getByRole('status').filter({ visible: true }).last()).toContainText('sphere.centre');
    const form = page.locator('form.check').first();
    await form.locator('input[type=file]').setInputFiles({ name: 'step04_diffuse.png', mimeType: 'image/png', buffer: picture('step04_diffuse') });
    await expect(form.locator('output')).toContainText('Right', { timeout: 20_000 });
    await page.locator('#theme-toggle').click();
    await page.reload();
    await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
    await expect(page.locator('html')).toHaveClass(/js/);
  });
});

test('if a server allows no trusted types, a page says what is missing', async ({ browser }) => {
  await withPolicy(browser, `${POLICY}; trusted-types 'none'`, async (page, home) => {
    await page.goto(home + name);
    await expect(page.locator('.missing')).toHaveText(/did not load.*Content-Security-Policy/);
    await page.locator('#theme-toggle').click();
    await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
  });
  // If the policy doesn't require trusted types, nothing is missing.
  const policy = POLICY.replace(`; require-trusted-types-for 'script'`, '');
  await withPolicy(browser, `${policy}; trusted-types 'none'`, async (page, home) => {
    const figure = await findFigure(page, home + name);
    await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
    await expect(page.locator('.missing')).toHaveCount(0);
  });
});

test('under trusted types, only the HTML and scripts of the page itself are let through', async ({ browser }) => {
  await withPolicy(browser, `${POLICY}; trusted-types default`, async (page, home) => {
    const figure = await findFigure(page, home + name);
    await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
    const isRefused = act => page.evaluate(`try { ${act}; "written" } catch (error) { error.name }`);
    expect(await isRefused('document.querySelector("h1").innerHTML = "<i>text</i>"')).toBe('TypeError');
    expect(await isRefused('document.createElement("script").src = "book.js?other"')).toBe('TypeError');
  });
});
