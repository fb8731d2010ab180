// A link that names a pixel selects it.
import { expect, open, test } from './fixtures.js';

test('a link that names a pixel selects it, and Back returns to the link', async ({ page, home }) => {
  await open(page, `${home}step03_nearest.html`);
  // Lay out everything above, as if the reader had scrolled down to here.
  await page.locator('main > *').evaluateAll(parts => parts.forEach(part => { part.style.contentVisibility = 'visible'; }));
  const figure = page.locator('figure[data-live="step03_nearest"]');
  const link = page.locator('a[href$="#pixel=195,237"]').first();
  await link.scrollIntoViewIfNeeded();
  await figure.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });
  const place = (await link.boundingBox()).y;
  await link.click();
  await expect(figure).toBeInViewport();
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('195');
  await expect(figure.locator('.hint')).toHaveText(/^red, t = [\d.]+ .*\(\d+, \d+, \d+\)$/);
  await expect(figure.locator('.handle-probe')).toHaveAttribute('aria-valuetext', /^column 195, row 237: red, t = /);
  await expect(page.locator('[data-panel] tr.hit')).toHaveCount(1);
  await figure.locator('.handle-probe').press('ArrowRight');
  await link.click();
  await expect(page.locator('[data-panel] [data-number="step03_nearest:i"]')).toHaveText('195');
  await page.evaluate(() => history.back());
  // The text below the picture may be a line longer than before.
  await expect.poll(async () => Math.abs((await link.boundingBox()).y - place)).toBeLessThan(24);
});
