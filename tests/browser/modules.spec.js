// The modules, as they are checked in, draw what is locked and what the pages print.
import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { chapters, pagesWithFigures } from './book.js';
import { expect, open, test } from './fixtures.js';

const snapshots = readdirSync(resolve(import.meta.dirname, '../snapshots'));
const allLocked = snapshots.filter(name => name.endsWith('.snap.png')).map(name => name.replace('.snap.png', ''));
// The pictures of the steps, or with THOROUGH=1 those of the exercises, too.
const locked = process.env.THOROUGH ? allLocked : allLocked.filter(name => /^step\d\d_/.test(name));

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    // The bytes of a picture of the book; four a pixel, of which the last is 255.
    globalThis.readPixels = async src => {
      const image = Object.assign(new Image(), { src });
      await image.decode();
      const [width, height] = [image.naturalWidth, image.naturalHeight];
      const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
  });
});

test('check.wasm draws the locked pictures', async ({ page, home }) => {
  await open(page, home + chapters[0]);
  await page.waitForFunction(() => typeof wasmModules === 'object' && typeof ask === 'function');
  const [count, wrong] = await page.evaluate(async names => {
    const module = await wasmModules.get('check');
    let [count, wrong] = [0, []];
    for (const name of names) {
      let pixels;
      try {
        ({ pixels } = ask(module, `draw ${name}`));
      } catch {
        continue; // No answer: the picture is not one that a reader draws, such as the cover.
      }
      count += 1;
      const right = await readPixels(`generated/${name}.png`);
      if (right.some((byte, k) => k % 4 < 3 && byte !== pixels[(k >> 2) * 3 + k % 4])) wrong.push(name);
    }
    return [count, wrong];
  }, locked);
  expect(wrong).toEqual([]);
  expect(count).toBeGreaterThanOrEqual(process.env.THOROUGH ? 30 : 5);
});

for (const name of pagesWithFigures) {
  test(`${name}: live.wasm draws what is printed`, async ({ page, home }) => {
    await open(page, home + name);
    await page.waitForFunction(() => typeof wasmModules === 'object' && typeof ask === 'function');
    const wrong = await page.evaluate(async () => {
      const module = await wasmModules.get('live');
      const wrong = [];
      for (const figure of document.querySelectorAll('figure[data-live]')) {
        const { values } = ask(module, `about ${figure.dataset.live}`);
        const { drawing, pixels } = ask(module, `show ${figure.dataset.live} ${values.join(' ')}`);
        const printed = figure.querySelector('svg g, img');
        let same;
        if (pixels) {
          const right = await readPixels(printed.src);
          same = right.length === pixels.length && right.every((byte, k) => byte === pixels[k]);
        } else {
          const copy = printed.cloneNode();
          copy.innerHTML = drawing;
          same = copy.isEqualNode(printed);
        }
        if (!same) wrong.push(figure.dataset.live);
      }
      return wrong;
    });
    expect(wrong).toEqual([]);
  });
}
