// Every page shows all of itself, and the browser has nothing to complain of.
import { chapters, pages } from './book.js';
import { expect, open, test } from './fixtures.js';

for (const name of pages) {
  test(`${name} shows its pictures and does not scroll sideways`, async ({ page, home }) => {
    await open(page, home + name);
    // What is folded away or far below is looked at, too, and no picture is left for later.
    const [sideways, missing] = await page.evaluate(async () => {
      document.querySelectorAll('details').forEach(box => { box.open = true; });
      document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; });
      const [root, pictures] = [document.documentElement, [...document.images]];
      pictures.forEach(one => { one.loading = 'eager'; });
      await Promise.all(pictures.map(one => one.decode().catch(() => {})));
      const missing = pictures.filter(one => one.naturalWidth === 0).map(one => one.src);
      return [root.scrollWidth - root.clientWidth, missing];
    });
    expect.soft(sideways, 'pixels that it scrolls sideways').toBeLessThanOrEqual(1);
    expect.soft(missing, 'pictures that do not load').toEqual([]);
  });
}

test('the server sends the policy with each page', async ({ request, served }) => {
  for (const name of chapters) {
    const response = await request.head(served + name);
    expect(response.headers()['content-security-policy'], name).toContain(`default-src 'none'`);
  }
});

test('the browser shows the view that its project names', async ({ page, home }, { project }) => {
  await open(page, home + pages[0]);
  const isDark = await page.evaluate(() => matchMedia('(prefers-color-scheme: dark)').matches);
  expect(isDark).toBe(project.name.endsWith('-dark'));
  expect(await page.evaluate(() => innerWidth)).toBe(project.name.includes('-narrow') ? 390 : 1280);
});
