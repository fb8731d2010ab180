// Opens every page of the built book, as a reader with a wide and a narrow screen, in light and
// in dark, from the file system. Fails where a page has an error, asks for anything outside the
// book, scrolls sideways, shows a broken picture, or breaks a rule of accessibility.
//
//     node audit.mjs FOLDER          (CHROMIUM names the browser)
import { chromium } from 'playwright-core';
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.argv[2]);
const home = pathToFileURL(folder).href + '/';
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
// 404.html is for a server's root, toc.html for browsers without scripts.
const other = ['404.html', 'toc.html'];
const pages = readdirSync(folder).filter(name => name.endsWith('.html') && !other.includes(name));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'],
});

const faults = new Set();
let views = 0;
// All pages in one kind of view, one after the other.
async function look(width, colorScheme) {
  const context = await browser.newContext({ colorScheme, viewport: { width, height: 900 } });
  const tab = await context.newPage();
  let page = '';
  const fault = what => faults.add(`${page} (${width} px, ${colorScheme}): ${what}`);
  tab.on('console', message => message.type() === 'error' && fault(message.text()));
  tab.on('pageerror', error => fault(String(error)));
  // What a page still loads when it is left is broken off by the browser.
  tab.on('requestfailed', request => {
    const why = request.failure().errorText;
    if (why !== 'net::ERR_ABORTED') fault(`can't load ${request.url()}: ${why}`);
  });
  tab.on('request', request => {
    const inside = request.url().startsWith(home) || request.url().startsWith('data:');
    if (!inside) fault(`asks for ${request.url()}`);
  });
  for (page of pages) {
    // All pages in one: what is looked at in them is not looked at here again.
    const isPrint = page === 'print.html';
    if (isPrint && colorScheme === 'dark') continue;
    views += 1;
    await tab.goto(home + page, { waitUntil: 'load' });
    // Everything folded away is looked at as well, and pictures are not left for later.
    await tab.evaluate(async () => {
      document.querySelectorAll('details').forEach(box => { box.open = true; });
      const pictures = [...document.images];
      pictures.forEach(picture => { picture.loading = 'eager'; });
      await Promise.all(pictures.filter(picture => !picture.complete).map(picture =>
        new Promise(done => { picture.onload = picture.onerror = done; })));
    });
    const seen = await tab.evaluate(() => ({
      sideways: document.documentElement.scrollWidth - document.documentElement.clientWidth,
      broken: [...document.images].filter(i => i.naturalWidth === 0).map(i => i.src),
    }));
    if (1 < seen.sideways) fault(`scrolls sideways by ${seen.sideways} px`);
    seen.broken.forEach(picture => fault(`shows no picture for ${picture}`));
    // Colours do not depend on the width, and nothing else on dark.
    const isDark = colorScheme === 'dark';
    if (width < 1280 && (isDark || isPrint)) continue;
    // All is laid out, and what scrolls sideways has been found.
    await tab.waitForSelector('main[data-ready]');
    const later = await tab.evaluate(() => [...document.querySelectorAll('main *')].filter(part =>
      part.checkVisibility() && !part.checkVisibility({ contentVisibilityAuto: true })).length);
    if (later) fault(`leaves ${later} elements blank that are far from the view`);
    await tab.evaluate(axe);
    const { violations } = await tab.evaluate(options => window.axe.run(options), {
      preload: false,
      ...(isDark && { runOnly: ['color-contrast'] }),
      ...(isPrint && { rules: { 'color-contrast': { enabled: false } } }),
    });
    for (const { id, help, nodes } of violations) {
      fault(`${id}: ${help}, at ${nodes[0].target.join(' ')}`);
    }
  }
  // The search finds something without a server.
  page = 'index.html';
  await tab.goto(home + page);
  await tab.keyboard.press('s');
  await tab.keyboard.type('discriminant');
  const found = tab.locator('#mdbook-searchresults a, #searchresults a').first();
  await found.waitFor({ timeout: 5000 }).catch(() => fault('the search finds nothing'));
  await context.close();
}

// The views do not wait for each other.
await Promise.all(
  [1280, 390].flatMap(width => ['light', 'dark'].map(scheme => look(width, scheme))),
);
await browser.close();

for (const what of [...faults].sort()) console.log(what);
console.log(`${views} views of ${pages.length} pages, ${faults.size} faults`);
process.exit(faults.size ? 1 : 0);
