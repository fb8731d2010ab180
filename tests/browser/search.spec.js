// The search finds the section to which a teacher would send a reader, and the page scrolls to it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, open, test } from './fixtures.js';

// Pairs of [what a reader types, the right places].
const queries = readFileSync(join(import.meta.dirname, 'search_queries.txt'), 'utf8').trim().split('\n')
  .map(line => line.split(' → ')).map(([query, places]) => [query, places.split(' or ')]);

// Opens the search with its key, which only works once its script has run, and types a query.
// Returns the first result.
async function search(page, query) {
  const field = page.locator('#search-field');
  await expect(async () => {
    await page.keyboard.press('s');
    await expect(field).toBeFocused({ timeout: 100 });
  }).toPass({ timeout: 15_000 });
  await field.fill(query);
  await expect(page.locator('#search-status')).not.toBeEmpty();
  return page.locator('#search-results a').first();
}

test('all first results except at most five are right', async ({ page, home }) => {
  await open(page, `${home}introduction.html`);
  const wrong = [];
  for (const [query, places] of queries) {
    const address = await (await search(page, query)).getAttribute('href');
    if (!places.includes(address)) wrong.push(`${query}: ${address}`);
  }
  const sections = await page.evaluate(() => book.searchIndex.flatMap(([page, , sections]) => sections.map(([id]) => `${page}#${id}`)));
  expect(queries.flatMap(([, places]) => places).filter(place => !sections.includes(place)), 'places that are gone').toEqual([]);
  expect(wrong.length, wrong.join('\n')).toBeLessThanOrEqual(5);
});

test('Enter goes to the heading', async ({ page, home }) => {
  test.setTimeout(600_000);
  for (const [query] of queries.filter((_, k) => process.env.THOROUGH || k % 30 === 0)) {
    await open(page, `${home}introduction.html`);
    // First from a different page, then from the end of the page itself.
    for (const way of ['from another page', 'on its own page']) {
      const address = new URL(await (await search(page, query)).getAttribute('href'), page.url());
      await page.keyboard.press('Enter');
      await page.waitForURL(address.href);
      await expect(page.locator('#search')).toBeHidden();
      await page.waitForTimeout(400); // Parts that come into view may still be laid out.
      await expect.soft(page.locator(`[id="${address.hash.slice(1)}"]`), `${query} ${way}`).toBeInViewport();
      await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    }
  }
});

test('the search keeps the reader’s place, and offers near matches', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  // Lay out everything first, since a part above that is laid out later would move the reader's
  // place as well.
  await page.locator('main > *').evaluateAll(parts => parts.forEach(part => { part.style.contentVisibility = 'visible'; }));
  await page.evaluate(() => scrollTo(0, 2000));
  const place = await page.evaluate(() => scrollY);
  const result = await search(page, 'sphere zebra');
  await expect(page.locator('#search-status')).toContainText('near');
  await page.keyboard.press('ArrowDown');
  await expect(result).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(page.locator('#search')).toBeHidden();
  // A figure that becomes ready may move the place by a line.
  expect(Math.abs(await page.evaluate(() => scrollY) - place)).toBeLessThan(30);
  await search(page, 'qqqqq');
  await expect(page.locator('#search-status')).toContainText('Nothing');
});

test('names of JavaScript are words, and ten thousand letters don\'t hold the page', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  for (const word of ['constructor', '__proto__', 'hasOwnProperty', 'toString']) {
    await search(page, word);
    // Similar words may be found, but not the words of `function Object() { [native code] }`.
    const found = await page.locator('#search-results em').allTextContents();
    expect(found.filter(text => /^(object|native|code|function)s?$/i.test(text)), word).toEqual([]);
  }
  for (const text of ['a-'.repeat(5000), 'sphere '.repeat(1500), 'x'.repeat(10_000)]) {
    const time = await page.evaluate(text => {
      const field = document.getElementById('search-field'), start = performance.now();
      field.value = text;
      field.dispatchEvent(new Event('input', { bubbles: true }));
      return performance.now() - start;
    }, text);
    expect(time, text.slice(0, 20)).toBeLessThan(500);
  }
});
