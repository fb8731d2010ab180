// The search finds the section to which a teacher would send a reader, and the page scrolls to that
// section.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, open, test } from './fixtures.js';

// For each query: the query, and the places to which the first result may lead. A place is one of
// these:
//
// - an address,
// - `hint`, if the query is a message from the compiler, and the search should say what to do about
//   it,
// - `nothing`, if the book has nothing about the query.
const queries = readFileSync(join(import.meta.dirname, 'search_queries.txt'), 'utf8').trim().split('\n')
  .map(line => line.split(' → ')).map(([query, places]) => [query, places.split(' or ')]);

// Opens the search with a key, and types a query. Presses the key until the search opens, because
// the script of the search may not have run yet. If the query is null, the previous query stays in
// the field. Returns the first result.
async function search(page, query) {
  const field = page.locator('#search-field');
  await expect(async () => {
    await page.keyboard.press('s');
    await expect(field).toBeFocused({ timeout: 100 });
  }).toPass({ timeout: 15_000 });
  if (query !== null) await field.fill(query);
  await expect(page.locator('#search-status')).not.toBeEmpty();
  return page.locator('#search-results a').first();
}

test('first results are right for 19 of 20 queries', async ({ page, home }) => {
  await open(page, `${home}introduction.html`);
  await search(page, 'ray');
  // Type all queries within the page, because a round trip to the browser for each query would be
  // slow.
  const found = await page.evaluate(queries => queries.map(([query]) => {
    const field = document.getElementById('search-field');
    field.value = query;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    const status = document.getElementById('search-status').textContent;
    const address = document.querySelector('#search-results a').getAttribute('href');
    return status.startsWith('Nothing') ? 'nothing' : status.includes('message') ? 'hint' : address;
  }), queries);
  const wrong = queries.flatMap(([query, places], k) => places.includes(found[k]) ? [] : [`${query}: ${found[k]}`]);
  const sections = await page.evaluate(() => book.searchIndex.flatMap(([page, , sections]) => sections.map(([id]) => `${page}#${id}`)));
  const addresses = queries.flatMap(([, places]) => places).filter(place => place.includes('#'));
  expect(addresses.filter(place => !sections.includes(place)), 'places that the book no longer has').toEqual([]);
  expect(wrong.length, wrong.join('\n')).toBeLessThanOrEqual(queries.length / 20);
});

test('what the book doesn\'t have, and the compiler\'s messages, lead to a section that helps', async ({ page, home }) => {
  await open(page, `${home}introduction.html`);
  for (const [query, status, address] of [
    ['blockchain', 'Nothing', 'mistakes.html#what-went-wrong'],
    ['error[E0432]: unresolved import `crate::Ray`', 'message', 'step01_rays.html#a-ray'],
    ['error: linker `cc` not found', 'message', 'introduction.html#ray-casting-in-five-steps'],
    ['error[E0716]: temporary value dropped while borrowed', 'message', 'mistakes.html#what-went-wrong'],
  ]) {
    await expect(await search(page, query), query).toHaveAttribute('href', address);
    await expect(page.locator('#search-status'), query).toContainText(status);
    await expect(page.locator('#search-results a'), query).toHaveCount(1);
    await page.keyboard.press('Escape');
  }
});

test('keys open the search box, a click outside closes the box, and the query is kept on the next page', async ({ page, home }) => {
  await open(page, `${home}introduction.html`);
  const box = page.locator('#search');
  await search(page, 'lambert');
  for (const key of ['/', 's', 'Control+k']) {
    await page.keyboard.press('Escape');
    await expect(box).toBeHidden();
    await page.keyboard.press(key);
    await expect(box, key).toBeVisible();
  }
  // A click inside the search box leaves the box open. So does a selection that begins inside the
  // box and ends outside the box.
  const { x, y, width, height } = await box.boundingBox();
  await page.mouse.click(x + 5, y + 100);
  const field = await page.locator('#search-field').boundingBox();
  await page.mouse.move(field.x + 40, field.y + 10);
  await page.mouse.down();
  await page.mouse.move(x / 2, y + height / 2);
  await page.mouse.up();
  await expect(box).toBeVisible();
  await page.mouse.click(x + width / 2, 5);
  await expect(box).toBeHidden();
  await page.locator('#search-toggle').click();
  await expect(page.locator('#search-field')).toHaveValue('lambert');
  await page.keyboard.press('Enter');
  await page.waitForURL('**/step04_diffuse.html#*');
  // Load the page again instead of going back, because a test can't tell when Firefox has restored
  // a page.
  await open(page, `${home}introduction.html`);
  await search(page, null);
  await expect(page.locator('#search-field')).toHaveValue('lambert');
  await expect(page.locator('#search-results a').first()).toBeVisible();
});

test('Enter goes to the heading of the first result', async ({ page, home }) => {
  test.setTimeout(1_200_000);
  // One query for each place is enough.
  const ofPlaces = new Map(queries.filter(([, [place]]) => place.includes('#')).map(([query, [place]]) => [place, query]));
  for (const query of [...ofPlaces.values()].filter((_, k) => process.env.THOROUGH || k % 50 === 0)) {
    await open(page, `${home}introduction.html`);
    // Search first from a different page, then from the end of the page with the heading.
    for (const way of ['from another page', 'on its own page']) {
      const address = new URL(await (await search(page, query)).getAttribute('href'), page.url());
      await page.keyboard.press('Enter');
      await page.waitForURL(address.href);
      await expect(page.locator('#search')).toBeHidden();
      await page.waitForTimeout(400); // Wait until parts that come into view are laid out.
      await expect.soft(page.locator(`[id="${address.hash.slice(1)}"]`), `${query} ${way}`).toBeInViewport();
      await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    }
  }
});

test('opening the search does not scroll the page, and near matches are offered', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  // Lay out everything first. Otherwise, a part above the window might be laid out later, and
  // scroll the page.
  await page.locator('main > *').evaluateAll(parts => parts.forEach(part => { part.style.contentVisibility = 'visible'; }));
  await page.evaluate(() => scrollTo(0, 2000));
  const place = await page.evaluate(() => scrollY);
  const result = await search(page, 'sphere mirror zebra');
  await expect(page.locator('#search-status')).toContainText('near');
  await page.keyboard.press('ArrowDown');
  await expect(result).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(page.locator('#search')).toBeHidden();
  // A figure that becomes ready may scroll the page by a line.
  expect(Math.abs(await page.evaluate(() => scrollY) - place)).toBeLessThan(30);
  await search(page, 'qqqqq');
  await expect(page.locator('#search-status')).toContainText('Nothing');
});

test('names from JavaScript are ordinary words in a query, and a query of ten thousand letters doesn\'t block the page', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  for (const word of ['constructor', '__proto__', 'hasOwnProperty', 'toString']) {
    await search(page, word);
    // The search may find similar words. But if it looked up `constructor` in a plain object, it
    // would get the function `Object`. Then it would find the words of this function's text, which
    // is `function Object() { [native code] }`.
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
