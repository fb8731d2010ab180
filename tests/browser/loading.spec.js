// What fails to load once is loaded again.
import { figures } from './book.js';
import { expect, open, test } from './fixtures.js';

test('a module that fails to load is loaded again', async ({ browser, home }) => {
  const [name] = figures[0];
  // A page of its own: here the browser has to complain of the first load.
  const page = await browser.newPage();
  let loads = 0;
  await page.route('**/live-module.js', route => {
    loads += 1;
    return loads === 1 ? route.abort() : route.continue();
  });
  await open(page, home + name);
  const figure = page.locator('figure[data-live]').first();
  await figure.scrollIntoViewIfNeeded();
  await expect(figure).toHaveAttribute('data-ready', '', { timeout: 20_000 });
  expect(loads).toBe(2);
  await page.close();
});
