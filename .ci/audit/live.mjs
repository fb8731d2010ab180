// Moves everything live in the built book, by pointer and by keys: it has to change, and reset
// has to bring back what is printed, to the pixel. Asks each form whether pictures are right. Prints the median time of a frame, from the
// gesture to the pixels; nothing fails on time.
//
//     node live.mjs FOLDER          (CHROMIUM names the browser)
import { chromium } from 'playwright-core';
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.argv[2]);
const home = pathToFileURL(folder).href + '/';
const pages = readdirSync(folder).filter(name => name.endsWith('.html') && name !== 'print.html'
  && /<(figure|form)[^>]* data-live=/.test(readFileSync(join(folder, name), 'utf8')));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'],
});
const faults = [];
const frames = tab => tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

async function tryOut(tab, figure, where, source) {
  const fault = what => faults.push(`${where}: ${what}`);
  await figure.scrollIntoViewIfNeeded();
  await figure.and(tab.locator('[data-ready]')).waitFor({ timeout: 10000 });
  await frames(tab);
  // Everything that is to be seen of it: shapes and pixels, numbers and handles.
  const state = () => figure.evaluate(figure => {
    const canvas = figure.querySelector('canvas');
    const picture = canvas ? canvas.toDataURL() : figure.querySelector('svg').innerHTML;
    const handles = [...figure.querySelectorAll('.handle')].map(one => one.style.cssText + one.ariaValueText);
    const chosen = [...figure.querySelectorAll('select')].map(one => one.value);
    return JSON.stringify([picture, handles, chosen, figure.querySelector('figcaption')?.textContent]);
  });
  const printed = await state();
  if (source) {
    const png = readFileSync(join(folder, source)).toString('base64');
    const same = await figure.evaluate(async (figure, png) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const canvas = figure.querySelector('canvas');
      const locked = new OffscreenCanvas(image.width, image.height).getContext('2d');
      locked.drawImage(image, 0, 0);
      const [a, b] = [locked, canvas.getContext('2d')].map(c => c.getImageData(0, 0, image.width, image.height).data);
      return canvas.width === image.width && a.every((byte, k) => byte === b[k]);
    }, png);
    if (!same) fault('is not the locked picture');
  }
  const reset = figure.locator('.reset');
  const moved = async how => {
    await frames(tab);
    if (await state() === printed) fault(`does not change by ${how}`);
    if (await reset.isDisabled()) return;
    await reset.click();
    await frames(tab);
    if (await state() !== printed) fault(`reset does not undo ${how}`);
  };
  const grips = figure.locator('.handle');
  for (let k = 0; k < await grips.count(); k += 1) {
    const grip = grips.nth(k);
    const name = await grip.getAttribute('aria-label');
    await grip.scrollIntoViewIfNeeded();
    const box = await grip.boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await tab.mouse.move(x, y);
    await tab.mouse.down();
    await tab.mouse.move(x + 17, y - 23, { steps: 4 });
    await tab.mouse.up();
    await moved(`dragging ${name}`);
    for (const key of ['ArrowLeft', 'ArrowUp']) {
      await grip.focus();
      await tab.keyboard.press(key);
      await moved(`${key} on ${name}`);
    }
  }
  const knobs = figure.locator('.knobs input');
  for (let k = 0; k < await knobs.count(); k += 1) {
    const knob = knobs.nth(k);
    await knob.scrollIntoViewIfNeeded();
    const box = await knob.boundingBox();
    await tab.mouse.click(box.x + box.width * 0.8, box.y + box.height / 2);
    await moved(`pressing knob ${k}`);
    await knob.focus();
    await tab.keyboard.press(await knob.getAttribute('type') === 'range' ? 'ArrowLeft' : 'Space');
    await moved(`a key on knob ${k}`);
  }
  for (const select of await figure.locator('.knobs select').all()) {
    await select.selectOption({ index: 43 });
    await moved('choosing');
    await select.focus();
    await tab.keyboard.press('ArrowDown');
    await moved('a key on the choice');
  }
  // Frames: from a gesture until what it drew can be read. None waits for the screen.
  const median = await figure.evaluate(async figure => {
    const grip = figure.querySelector('.handle') ?? figure.querySelector('input[type=range]');
    const [canvas, svg] = [figure.querySelector('canvas'), figure.querySelector('svg')];
    const gesture = k => {
      if (grip.matches('.handle')) {
        const key = k % 2 ? 'ArrowLeft' : 'ArrowRight';
        return grip.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
      }
      grip.value = Number(grip.value) + (k % 2 ? 1 : -1);
      return grip.dispatchEvent(new Event('input', { bubbles: true }));
    };
    const { requestAnimationFrame } = window;
    const times = [];
    for (let k = 0; k < 60; k += 1) {
      window.requestAnimationFrame = draw => draw();
      const start = performance.now();
      gesture(k);
      if (canvas) canvas.getContext('2d').getImageData(0, 0, 1, 1);
      else svg.getBoundingClientRect();
      times.push(performance.now() - start);
      window.requestAnimationFrame = requestAnimationFrame;
      await new Promise(done => requestAnimationFrame(done));
    }
    return times.sort((a, b) => a - b)[30];
  });
  if (!await reset.isDisabled()) await reset.click();
  console.log(`${where}: ${median.toFixed(1)} ms a frame`);
}

// Asks the form whether a right picture is right, by a file that is chosen and by keys; then a
// wrong one, dropped, in the first form of a page; and what is no picture.
async function ask(tab, form, where, isFirst) {
  const fault = what => faults.push(`${where}: ${what}`);
  const output = form.locator('output');
  const says = async (words, time) => {
    const told = form.locator('output .said').filter({ hasText: words });
    await told.waitFor({ timeout: 30000 }).catch(async () => fault(`says "${await output.textContent()}", not "${words}"`));
    if (time) console.log(`${where}: ${Date.now() - time} ms to look at a picture`);
  };
  const reset = async () => {
    await form.locator('button').click();
    if (await output.textContent() !== '') fault('reset leaves an answer');
  };
  const named = await form.getAttribute('data-name');
  const name = named === '*' ? 'step04_diffuse' : named;
  const right = join(folder, 'pictures', `${name}.png`);
  await form.scrollIntoViewIfNeeded();
  const choosing = tab.waitForEvent('filechooser');
  await form.locator('input').focus();
  await tab.keyboard.press('Enter');
  let start = Date.now();
  await (await choosing).setFiles(right);
  await says(`Right: this is the picture of ${name}, in every pixel.`, start);
  await reset();
  const drop = (bytes, called) => form.evaluate((form, [bytes, called]) => {
    const files = new DataTransfer();
    files.items.add(new File([Uint8Array.from(atob(bytes), letter => letter.charCodeAt(0))], called));
    form.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
  }, [Buffer.from(bytes).toString('base64'), called]);
  await drop('my notes', 'notes.txt');
  await says('notes.txt is not a PNG file');
  await drop(readFileSync(right).subarray(0, 2000), `${name}.png`);
  await says('is a damaged PNG file');
  if (isFirst) {
    start = Date.now();
    const isAny = named === '*';
    const [wrong, words] = isAny
      ? ['mistake-no-exponent', 'is what you get when the exponent n is left out']
      : ['shadowed', `Not right yet: this is not the picture of ${name}`];
    await drop(readFileSync(join(folder, 'pictures', `${wrong}.png`)), isAny ? 'step05_phong.png' : `${name}.png`);
    await says(words, start);
    if (await form.locator('canvas').count() !== 3) fault('shows no difference');
  }
  await reset();
}

for (const page of pages) {
  const html = readFileSync(join(folder, page), 'utf8');
  for (const width of [1280, 390]) {
    const context = await browser.newContext({ viewport: { width, height: 900 } });
    const tab = await context.newPage();
    tab.on('pageerror', error => faults.push(`${page} (${width} px): ${error}`));
    tab.on('request', request => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(home)) faults.push(`${page} asks for ${request.url()}`);
    });
    await tab.goto(home + page, { waitUntil: 'load' });
    const figures = tab.locator('figure[data-live]');
    for (let k = 0; k < await figures.count(); k += 1) {
      const figure = figures.nth(k);
      const where = `${page} ${await figure.getAttribute('data-live')} (${width} px)`;
      const name = await figure.getAttribute('data-live');
      const source = html.match(`data-live="${name}"><img src="([^"]*)"`)?.[1];
      await tryOut(tab, figure, where, source).catch(error => faults.push(`${where}: ${error}`));
    }
    const forms = tab.locator('form[data-live=check]');
    for (let k = 0; k < await forms.count(); k += 1) {
      const form = forms.nth(k);
      const where = `${page} check ${await form.getAttribute('data-name')} (${width} px)`;
      await ask(tab, form, where, k === 0).catch(error => faults.push(`${where}: ${error}`));
    }
    await context.close();
  }
}
await browser.close();
faults.forEach(what => console.log(what));
console.log(`${pages.length} pages, ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
