// If there is room for a margin, the notes are in the margin, level with their blocks. Otherwise,
// the notes follow their blocks.
import { chapters } from './book.js';
import { expect, open, test } from './fixtures.js';

const SIDE_BY_SIDE = [1100, 1440, 1920];

// Opens a page, and makes the browser lay out all parts of the page.
async function openWhole(page, address) {
  await open(page, address);
  await page.locator('main > *').evaluateAll(parts => parts.forEach(part => { part.style.contentVisibility = 'visible'; }));
}

// Measures the boxes of the page's blocks, notes and tools, in pixels from the top left corner of
// the page.
const measure = () => {
  const box = part => {
    const { left, right, top, bottom } = part.getBoundingClientRect();
    return { name: part.textContent.trim().slice(0, 30), left, right, top: top + scrollY, bottom: bottom + scrollY };
  };
  const main = document.querySelector('main');
  return {
    page: document.documentElement.clientWidth,
    edge: box(document.querySelector('main > h1, main > .cover')).left + Number.parseFloat(getComputedStyle(document.querySelector('footer')).maxWidth),
    // Everything in the column of text. None of it may extend past the column's right edge.
    blocks: [...main.querySelectorAll(':scope > :not(.with-margin, .panels), :scope > .with-margin > :first-child')].map(box),
    frames: [...main.querySelectorAll(':scope > .with-margin')].map(frame => ({
      block: box(frame.firstElementChild),
      notes: [...frame.querySelectorAll(':scope > .note, :scope > .by-hand')].map(note => ({ ...box(note), cut: note.clientWidth && note.scrollWidth - note.clientWidth })),
    })),
    // Listings that scroll sideways although none of their lines is longer than 84 columns.
    narrow: [...main.querySelectorAll('.listing > pre')]
      .filter(pre => pre.scrollWidth > pre.clientWidth && pre.textContent.split('\n').every(line => line.length <= 84))
      .map(pre => pre.parentElement.dataset.path),
    tools: [...main.querySelectorAll('.tool')].map(box),
    height: document.documentElement.scrollHeight,
  };
};

// Describes what is wrong with a page on which the notes should be beside their blocks.
function findFaults({ page, edge, blocks, frames, narrow, height }) {
  const faults = blocks.filter(({ right }) => right > edge + 1).map(({ name, right }) => `${name} ends ${right - edge} px to the right of the text`);
  faults.push(...narrow.map(path => `the listing of ${path} scrolls`));
  let end = 0;
  for (const { block, notes } of frames) {
    for (const { name, left, right, top, bottom, cut } of notes) {
      const level = Math.max(block.top, end);
      if (top < end) faults.push(`${name} covers the note before it`);
      if (top > level + 30) faults.push(`${name} begins ${top - level} px below its place`);
      if (left < edge + 20 || right > page || cut > 0 || bottom > height) faults.push(`${name} is not in the margin, or cut off`);
      end = bottom;
    }
  }
  return faults;
}

for (const width of SIDE_BY_SIDE) {
  // Without THOROUGH=1, only one of these widths is tested.
  test(`notes stand beside their blocks at ${width} pixels, and no note covers another note${width === 1440 ? '' : ' @thorough'}`, async ({ page, home }) => {
    test.setTimeout(180_000);
    await page.setViewportSize({ width, height: 900 });
    let count = 0;
    // The page "A scene of your own" always has its controls in the margin, where the notes would
    // be.
    const isTried = name => name !== 'own_scene.html' && (process.env.THOROUGH || /^step|^way/.test(name));
    for (const name of chapters.filter(isTried)) {
      await openWhole(page, home + name);
      const layout = await page.evaluate(measure);
      expect.soft(findFaults(layout), name).toEqual([]);
      count += layout.frames.flatMap(({ notes }) => notes).length;
    }
    expect(count).toBeGreaterThan(50);
  });
}

test('notes that are too long for their blocks push each other down, and do not move the text', async ({ page, home }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openWhole(page, `${home}step02_sphere.html`);
  const { blocks } = await page.evaluate(measure);
  await page.locator('.with-margin > .note').evaluateAll(notes => notes.forEach(note => { note.textContent = note.textContent.repeat(9); }));
  const layout = await page.evaluate(measure);
  expect(findFaults(layout)).toEqual([]);
  expect(layout.frames.some(({ block, notes }) => notes.some(({ top }) => top > block.bottom)), 'a note is pushed down').toBe(true);
  // Compare the gaps between the blocks, not the blocks' positions, since a figure grows when it
  // becomes ready.
  const gaps = blocks => blocks.slice(1).map(({ top }, k) => Math.round(top - blocks[k].bottom));
  expect(gaps(layout.blocks)).toEqual(gaps(blocks));
});

for (const [width, media] of [[390, 'screen'], [1000, 'screen'], [1440, 'print']]) {
  test(`notes follow their blocks at ${width} pixels (${media})`, async ({ page, home, browserName }) => {
    test.skip(media === 'print' && browserName !== 'chromium', 'only Chromium shows a page as if printed');
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ media });
    await openWhole(page, `${home}step02_sphere.html`);
    const { frames } = await page.evaluate(measure);
    for (const { block, notes } of frames) {
      let end = block.bottom - 30; // A by-hand note may be beside the block's last line.
      for (const { name, top, bottom, right, cut } of notes) {
        expect.soft(top, name).toBeGreaterThan(end);
        expect.soft(right, name).toBeLessThanOrEqual(width);
        expect.soft(cut, name).toBeLessThanOrEqual(0);
        end = bottom - 30;
      }
    }
  });
}

test('an open tool takes up the margin, and the notes that were beside the tool follow their blocks', async ({ page, home }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openWhole(page, `${home}step02_sphere.html`);
  const index = 2; // There are notes above this block and notes below this block.
  await page.evaluate(index => {
    const tool = Object.assign(document.createElement('div'), { className: 'tool', textContent: 'A tool' });
    document.querySelectorAll('main > .with-margin')[index].firstElementChild.after(tool);
  }, index);
  const { edge, frames, tools: [{ left, top, bottom }] } = await page.evaluate(measure);
  const { block } = frames[index];
  expect(left).toBeGreaterThan(edge);
  expect(bottom - top).toBeGreaterThan(block.bottom - block.top - 1);
  expect(top).toBeGreaterThan(Math.max(block.top, frames[index - 1].notes.at(-1).bottom) - 1);
  expect(top).toBeLessThan(block.top + 30);
  for (const { notes } of frames.slice(0, index)) {
    for (const { left, name } of notes) expect.soft(left, name).toBeGreaterThan(edge);
  }
  for (const { block, notes } of frames.slice(index)) {
    for (const { right, top, name } of notes) {
      expect.soft(right, name).toBeLessThanOrEqual(edge + 1);
      expect.soft(top, name).toBeGreaterThan(block.bottom - 30);
    }
  }
});
