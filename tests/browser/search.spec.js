// The search finds the words of the book, names of Rust and signs included.
import { expect, open, test } from './fixtures.js';

const WORDS = ['discriminant', 'sqrt', 'to_radians', 'normalize_and_length', 'θ', 'for', 'f64::consts'];

for (const word of WORDS) {
  const details = { tag: word === WORDS[0] ? [] : '@thorough' };
  test(`the search finds ${word}`, details, async ({ page, home }) => {
    await open(page, `${home}introduction.html`);
    // The key works once the script of the search has run.
    const field = page.locator('#search-field');
    await expect(async () => {
      await page.keyboard.press('s');
      await expect(field).toBeFocused({ timeout: 100 });
    }).toPass({ timeout: 15_000 });
    await field.fill(word);
    const result = page.locator('#search-results a').first();
    await result.waitFor();
    // Arrow keys go through the results and turn no page.
    await page.keyboard.press('ArrowDown');
    await expect(result).toBeFocused();
    await page.keyboard.press('ArrowRight');
    expect(page.url()).toBe(`${home}introduction.html`);
  });
}

test('an address that searches for % opens', async ({ page, home }) => {
  await open(page, `${home}introduction.html?search=%`);
  await expect(page.locator('#search-field')).toHaveValue('%');
});
