// A pixel is asked by its numbers, and by a link that names it.
import { expect, open, test } from './fixtures.js';

const page3 = 'step03_nearest.html';
const picture = 'figure[data-live="step03_nearest"]';
// Opens the numbers of the pixel, which are folded.
const unfold = page => page.locator(`${picture} .exact summary`).click();
const field = (page, symbol) => page.locator(`${picture} .controls input[type=text]`).nth(symbol === 'i' ? 0 : 1);

test('a link that names a pixel asks it', async ({ page, home }) => {
  await open(page, home + page3);
  await page.locator('a[href$="#pixel=195,237"]').first().click();
  await expect(field(page, 'i')).toHaveValue('195');
  await expect(field(page, 'j')).toHaveValue('237');
  await expect(page.locator(picture)).toBeInViewport();
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('195');
});

test('an address that names a pixel opens with it', async ({ page, home }) => {
  await open(page, `${home}${page3}#pixel=320,180`);
  await expect(page.locator('[data-panel] [data-number="step03_nearest:object"]')).toHaveText('red');
});

test('a number that is typed counts, and the nearest allowed one follows', async ({ page, home }) => {
  await open(page, home + page3);
  await page.locator(picture).scrollIntoViewIfNeeded();
  await page.locator(`${picture}[data-ready]`).waitFor({ timeout: 20_000 });
  await unfold(page);
  await field(page, 'i').fill('1000');
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('639');
  await field(page, 'j').focus();
  await expect(field(page, 'i')).toHaveValue('639');
});

test('a pixel is told in one line below the picture, and Back leads to where one was', async ({ page, home }) => {
  await open(page, home + page3);
  const link = page.locator('a[href$="#pixel=195,237"]').first();
  // A reader who has come here has seen what is above, so that it has its height.
  await page.evaluate(() => document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; }));
  await link.scrollIntoViewIfNeeded();
  await page.locator(`${picture}[data-ready]`).waitFor({ timeout: 20_000 });
  const place = (await link.boundingBox()).y;
  await link.click();
  await expect(page.locator(`${picture} .hint`)).toHaveText(/^red, t = [\d.]+ .*\(\d+, \d+, \d+\)$/);
  await expect(page.locator(`${picture} .handle-probe`)).toHaveAttribute('aria-valuetext', /^column 195, row 237: red, t = /);
  await expect(page.locator('[data-panel] tr.hit')).toHaveCount(1);
  await page.evaluate(() => history.back());
  // What is told below the picture may be a line longer than before.
  await expect.poll(async () => Math.abs((await link.boundingBox()).y - place)).toBeLessThan(24);
});
