// A line of a listing that the reader edits is drawn, and the book's comes back.
import { execFileSync } from 'node:child_process';
import { resolve } from 'node:path';
import { expect, open, test } from './fixtures.js';

const STEP = 'step04_diffuse';
const NORMAL = '(p - sphere.centre) / sphere.radius';

// The line of the normal, in view, and what belongs to it.
async function prepare(page, home, hash = '') {
  await open(page, `${home}${STEP}.html${hash}`);
  const line = page.locator('[data-line=normal]');
  await line.scrollIntoViewIfNeeded();
  const listing = page.locator('figure', { has: line });
  await listing.locator('code.hljs').or(listing.locator('canvas')).first().waitFor();
  return { line, listing, status: listing.getByRole('status') };
}

// How many bytes of the canvas differ from a picture of the book.
const difference = (listing, png) => listing.locator('canvas').evaluate(async (canvas, png) => {
  const image = new Image();
  image.src = document.querySelector(`main img[src$="${png}"]`).src;
  await image.decode();
  const bytes = from => {
    const copy = Object.assign(document.createElement('canvas'), { width: 640, height: 360 }).getContext('2d');
    copy.drawImage(from, 0, 0);
    return copy.getImageData(0, 0, 640, 360).data;
  };
  const ours = bytes(image);
  return canvas.width === 640 ? bytes(canvas).filter((byte, k) => byte !== ours[k]).length : -1;
}, png);

test('the book’s line draws the book’s picture', async ({ page, home, source }) => {
  test.skip(source === 'folder', 'pixels of a file can not be read');
  const { line, listing, status } = await prepare(page, home);
  await line.click();
  await expect(status).toContainText('sphere.centre');
  expect(await difference(listing, `${STEP}.png`)).toBe(0);
});

test('an edit is drawn, a mistake is underlined, Escape brings the line back, and undo all of it', async ({ page, home }) => {
  const { line, listing, status } = await prepare(page, home);
  await line.focus();
  await page.keyboard.press('Enter');
  await expect(line).toHaveAttribute('role', 'textbox');
  await expect(status).toContainText('sphere.centre');
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.type('p - sphere.centre');
  await expect(status).toHaveText(/A known mistake gives the same pixels: n is not a unit vector/);
  await expect(page).toHaveURL(/#line=normal:p%20-%20sphere\.centre$/);
  await expect(listing.locator('canvas')).toBeInViewport();
  await page.keyboard.type(' * 2');
  await expect(status).toContainText('Write 2.0');
  await expect(line).toHaveAttribute('aria-invalid', 'true');
  await expect(listing.locator('.wrong')).toHaveCount(1);
  await listing.getByRole('button', { name: 'Reset' }).click();
  await expect(line).toHaveText(NORMAL);
  await expect(listing.locator('.wrong')).toHaveCount(0);
  await page.keyboard.type('x');
  await page.keyboard.press('Escape');
  await expect(line).toHaveText(NORMAL);
  await expect(line).toBeFocused();
  await expect(listing.locator('canvas')).toHaveCount(0);
  expect(page.url()).not.toContain('#line');
  for (const text of [`x${NORMAL}`, NORMAL, 'p - sphere.centre * 2']) {
    await page.keyboard.press('ControlOrMeta+Z');
    await expect(line).toHaveText(text);
  }
  await listing.getByRole('button', { name: 'Redo' }).click();
  await expect(line).toHaveText(NORMAL);
  await listing.getByRole('button', { name: 'Close' }).click();
  await expect(listing.locator('canvas')).toHaveCount(0);
});

test('lines that are let go stay in the picture, the address and the history', async ({ page, home }) => {
  const { line } = await prepare(page, home, '#line=normal:p%20%2A%200.3&line=attenuation:%281.0');
  const other = page.locator('[data-line=attenuation]');
  const status = page.getByRole('status').filter({ visible: true }).last();
  await expect(status).toHaveText('In another line of yours: The ) for this is missing.');
  await other.click();
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.type('1.0');
  await expect(page).toHaveURL(/#line=attenuation:1\.0&line=normal:p%20%2A%200\.3$/);
  await expect(line).toHaveText('p * 0.3');
  await expect(status).toHaveText(/Drawn/);
  await page.keyboard.press('ControlOrMeta+Z');
  await expect(other).toHaveText('(1.0');
});

test('no text keeps a line from being drawn later', async ({ page, home }) => {
  const { line, status } = await prepare(page, home);
  await line.click();
  for (const [text, words] of [['('.repeat(41), 'inside each other'], ['-'.repeat(10_000), 'longer than a line'], ['p', 'Drawn']]) {
    await line.evaluate((line, text) => { line.textContent = text; line.dispatchEvent(new Event('input', { bubbles: true })); }, text);
    await expect(status).toContainText(words);
  }
  await page.evaluate(async () => {
    const [{ ask }, broken] = [window, await wasmModules.get('expressions')];
    window.ask = (module, ...words) => { if (module === broken) throw new WebAssembly.RuntimeError(); return ask(module, ...words); };
  });
  await page.keyboard.press('Enter');
  await expect(status).toContainText('Press Enter to try again');
  await page.keyboard.press('Enter');
  await expect(status).toContainText('Drawn');
});

for (const [width, height] of [[390, 508], [640, 400]]) {
  test(`line, message and picture are in view together at ${width}×${height}`, async ({ page, home }) => {
    await page.setViewportSize({ width, height });
    const { line, listing, status } = await prepare(page, home);
    await line.click();
    await page.keyboard.press('Home');
    await page.keyboard.type('p.nosuch() + ');
    await expect(status).toContainText('.nosuch isn\'t known here');
    const panel = await listing.locator('.panel').boundingBox();
    const { y, height: rows } = await line.boundingBox();
    expect(y).toBeGreaterThan(40);
    expect(y + rows).toBeLessThanOrEqual(panel.y);
    for (const part of [status, listing.locator('canvas')]) await expect(part).toBeInViewport({ ratio: 0.9 });
  });
}

test('an address holds an edit, also as mail programs write it', async ({ page, home }) => {
  const { line, listing, status } = await prepare(page, home, '#line=normal%3Ap%20%2A%20%282%29');
  await expect(line).toHaveText('p * (2)');
  await expect(status).toContainText('Write');
  await expect(listing.locator('canvas')).toBeVisible();
  await expect(line).toBeInViewport();
});

test('what is copied is the book’s listing, or a diff that git applies', async ({ page, home }) => {
  const copied = [];
  await page.exposeFunction('keep', text => { copied.push(text); });
  await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: { writeText: text => window.keep(text) } }));
  const { line, listing, status } = await prepare(page, home, '#line=normal:p');
  await expect(status).toHaveText(/Drawn|known mistake/);
  await listing.getByRole('button', { name: /^Copy step04/ }).click();
  await listing.getByText('Copy …').click();
  await listing.getByRole('button', { name: 'Copy as a diff' }).click();
  await expect.poll(() => copied.length).toBe(2);
  expect(copied[0]).toContain(`    ${NORMAL}\n}`);
  expect(copied[1]).toContain(`-    ${NORMAL}\n+    p\n`);
  const root = resolve(import.meta.dirname, '../..');
  execFileSync('git', ['apply', '--check'], { cwd: root, input: copied[1] });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await expect(line).toHaveText(NORMAL);
});
