// Moves everything live in the built book, by pointer and by keys: it has to change, and reset
// has to bring back what is printed, to the pixel. Asks each form whether pictures are right.
// On a narrow screen only what depends on its width: handles are dragged, pictures pressed, and
// a page's first form is asked, in Chromium and in Firefox. Prints the median time of a frame,
// from the gesture to the pixels, and of an answer that draws nothing anew, with another page at
// work; nothing fails on time.
//
//     node live.mjs FOLDER          (CHROMIUM and FIREFOX name the browsers)
import { chromium, firefox } from 'playwright-core';
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { serve } from './server.mjs';

const folder = resolve(process.argv[2]);
// A wide screen gets the pages from a server, a narrow one from the folder.
const server = await serve(folder);
const homes = { 1280: server.home, 390: pathToFileURL(folder).href + '/' };
const pages = readdirSync(folder).filter(name => name.endsWith('.html') && name !== 'print.html'
  && /<(figure|form)[^>]* data-live=/.test(readFileSync(join(folder, name), 'utf8')));
const chrome = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'],
});
const fox = await firefox.launch({ channel: 'moz-firefox', executablePath: process.env.FIREFOX });
const faults = [];
const frames = tab => tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

async function tryOut(tab, figure, where, source, isWide) {
  const fault = what => faults.push(`${where}: ${what}`);
  await figure.scrollIntoViewIfNeeded();
  await figure.and(tab.locator('[data-ready]')).waitFor({ timeout: 10000 });
  await frames(tab);
  // Everything that is to be seen of it: shapes and pixels, numbers and handles.
  const state = () => figure.evaluate(figure => {
    const canvas = figure.querySelector('canvas');
    const picture = canvas ? canvas.toDataURL() : figure.querySelector('svg').innerHTML;
    const handles = [...figure.querySelectorAll('.handle')].map(one => one.hidden + one.style.cssText + one.ariaValueText);
    const beside = document.querySelector(`[data-beside="${figure.dataset.live}"] g`)?.innerHTML;
    const listed = [...figure.querySelectorAll('.list select')].map(one => one.value);
    return JSON.stringify([picture, handles, listed, figure.querySelector('figcaption')?.textContent, beside]);
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
  const grips = figure.locator('.handle:visible');
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
    for (const key of isWide ? ['ArrowLeft', 'ArrowUp'] : []) {
      await grip.focus();
      await tab.keyboard.press(key);
      await moved(`${key} on ${name}`);
    }
  }
  // A press on no handle brings the cross, and what stands beside the picture follows.
  const canvas = figure.locator('.asked-by-press');
  if (await canvas.count()) {
    const beside = tab.locator(`[data-beside="${await figure.getAttribute('data-live')}"] g`);
    const drawing = async () => await beside.count() ? await beside.innerHTML() : 'none';
    const before = await drawing();
    const cross = await grips.first().getAttribute('style');
    const box = await canvas.boundingBox();
    await canvas.click({ position: { x: box.width * 0.2, y: box.height * 0.75 } });
    await frames(tab);
    if (await grips.first().getAttribute('style') === cross) fault('a press does not bring the cross');
    if (before !== 'none' && await drawing() === before) fault('what stands beside it does not move');
    await moved('a press on the picture');
  }
  if (!isWide) return;
  // Where the knobs of one thing are shown at a time, one of each kind is chosen.
  const choice = figure.locator('.choice select');
  const has = await choice.count() > 0;
  for (const thing of has ? ['red sphere', 'tenth sphere', 'warm light', 'ambient light', 'camera'] : ['it']) {
    if (has) await choice.selectOption(thing);
    const knobs = figure.locator('.knobs input:visible');
    for (let k = 0; k < await knobs.count(); k += 1) {
      const knob = knobs.nth(k);
      // What is left out of a scene is not seen to change.
      if (thing === 'tenth sphere' && k > 0) break;
      await knob.scrollIntoViewIfNeeded();
      const box = await knob.boundingBox();
      await tab.mouse.click(box.x + box.width * 0.8, box.y + box.height / 2);
      await moved(`pressing knob ${k} of ${thing}`);
      await knob.focus();
      await tab.keyboard.press(await knob.getAttribute('type') === 'range' ? 'ArrowLeft' : 'Space');
      await moved(`a key on knob ${k} of ${thing}`);
    }
  }
  for (const list of await figure.locator('.list select').all()) {
    await list.selectOption({ index: 43 });
    await moved('choosing from the list');
    await list.focus();
    await tab.keyboard.press('ArrowDown');
    await moved('a key on the list');
  }
  if (has) await keep(tab, figure, fault);
  // A lamp outside the picture gets its handle when its numbers bring it in.
  const outside = figure.locator('.handle[hidden]');
  if (!has && await outside.count()) {
    const name = await outside.first().getAttribute('aria-label');
    const ranges = figure.locator('.knobs label', { hasText: name }).locator('input');
    for (const [k, value] of [-1, 1, -5].entries()) await ranges.nth(k).fill(String(value));
    await frames(tab);
    if (await outside.count()) fault(`${name} has no handle in the picture`);
    await moved(`bringing ${name} in`);
    if (!await outside.count()) fault(`${name} keeps its handle outside the picture`);
  }
  const asking = await median(figure.locator('.handle.cross'));
  const moving = await median(figure.locator('.handle:not(.cross):visible, .knobs input:visible'));
  if (!await reset.isDisabled()) await reset.click();
  const times = [moving && `${moving} ms a frame`, asking && `${asking} ms to ask`].filter(Boolean);
  console.log(`${where}: ${times.join(', ')}`);
}

// What was made in a page is in its address: another tab shows the same there, and nonsense gets a sentence.
async function keep(tab, figure, fault) {
  const seen = tab => tab.evaluate(() => JSON.stringify([
    document.querySelector('figure[data-ready] canvas').toDataURL(), document.querySelector('[data-code] code').textContent]));
  const printed = await seen(tab);
  for (const name of ['red sphere', 'cool light']) {
    await figure.locator(`.handle[aria-label="${name}"]`).focus();
    await tab.keyboard.press('Shift+ArrowLeft');
  }
  await figure.locator('.choice select').selectOption('ground');
  await figure.locator('.knobs label:not([hidden]) > input[type=range]').last().press('Home');
  await tab.waitForTimeout(400);
  const made = await seen(tab);
  const other = await tab.context().newPage();
  await other.goto(tab.url());
  await other.locator('figure[data-ready]').waitFor();
  await frames(other);
  if (made === printed) fault('nothing was made');
  if (await seen(other) !== made) fault(`shows another scene at ${tab.url()}`);
  await other.evaluate(() => { navigator.clipboard.writeText = async text => { window.copied = text; }; });
  await other.locator('[data-code] .copy').click();
  if (await other.evaluate(() => window.copied) !== JSON.parse(made)[1]) fault('copies other Rust than it shows');
  for (const nonsense of ['red-sphere-radius:0', 'red-sphere-radius:large', 'moon-radius:1', '%', 'camera-field-of-view:180']) {
    await other.evaluate(hash => { location.hash = hash; }, `scene=${nonsense}`);
    await other.locator('.refused:has-text("Nothing has changed.")').waitFor({ timeout: 2000 })
      .catch(() => fault(`says nothing of ${nonsense}`));
    if (await seen(other) !== made) fault(`changes by ${nonsense}`);
    await other.evaluate(hash => { location.hash = hash; }, tab.url().split('#')[1]);
    await other.locator('.refused:empty').waitFor({ state: 'attached', timeout: 2000 }).catch(() => fault('goes on about nonsense'));
  }
  await other.close();
  await figure.locator('.reset').click();
  await tab.waitForTimeout(400);
  if (tab.url().includes('#') || await seen(tab) !== printed) fault('reset leaves something');
}
// The median time, in milliseconds, from a gesture on the first of these until what it drew
// can be read. None waits for the screen.
const median = async parts => await parts.count() && parts.first().evaluate(async part => {
  const figure = part.closest('figure');
  const [canvas, svg] = [figure.querySelector('canvas'), figure.querySelector('svg')];
  const gesture = k => {
    if (part.matches('.handle')) {
      const key = k % 2 ? 'ArrowLeft' : 'ArrowRight';
      return part.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
    }
    if (part.type === 'checkbox') return part.click();
    part.value = Number(part.value) + Number(part.step) * (k % 2 ? 1 : -1);
    return part.dispatchEvent(new Event('input', { bubbles: true }));
  };
  const { requestAnimationFrame } = window;
  const times = [];
  for (let k = 0; k < 31; k += 1) {
    const waiting = [];
    window.requestAnimationFrame = draw => waiting.push(draw);
    const start = performance.now();
    gesture(k);
    waiting.forEach(draw => draw());
    if (canvas) canvas.getContext('2d').getImageData(0, 0, 1, 1);
    else svg.getBoundingClientRect();
    times.push(performance.now() - start);
    window.requestAnimationFrame = requestAnimationFrame;
    await new Promise(done => requestAnimationFrame(done));
  }
  return times.sort((a, b) => a - b)[15].toFixed(1);
});

// Asks the form whether a right picture is right, by a file that is chosen and by keys; then a
// wrong one, dropped, if it is asked thoroughly; and what is no picture.
async function ask(tab, form, where, isThorough) {
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
  await drop(readFileSync(right).subarray(0, 1000), `${name}.png`);
  await says('is a damaged PNG file');
  if (isThorough) {
    start = Date.now();
    await drop(readFileSync(join(folder, 'pictures', 'shadowed.png')), `${name}.png`);
    await says('Not right', start);
    if (await form.locator('canvas').count() !== 3) fault('shows no difference');
  }
  await reset();
}

async function tryPage(browser, page, width) {
  const [isWide, home] = [width === 1280, homes[width]];
  const at = `(${width} px, ${browser.browserType().name()})`;
  const html = readFileSync(join(folder, page), 'utf8');
  const context = await browser.newContext({ viewport: { width, height: 900 } });
  const tab = await context.newPage();
  tab.on('pageerror', error => {
    // Firefox says so of a formula that is drawn before all of it has come.
    if (!/Incorrect number of children for <m/.test(error)) faults.push(`${page} ${at}: ${error}`);
  });
  tab.on('request', request => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(home)) faults.push(`${page} asks for ${request.url()}`);
  });
  await tab.goto(home + page, { waitUntil: 'load' });
  const figures = tab.locator('figure[data-live]');
  for (let k = 0; k < await figures.count(); k += 1) {
    const figure = figures.nth(k);
    const name = await figure.getAttribute('data-live');
    const where = `${page} ${name} ${at}`;
    const source = html.match(`data-live="${name}"><img src="([^"]*)"`)?.[1];
    await tryOut(tab, figure, where, source, isWide).catch(error => faults.push(`${where}: ${error}`));
  }
  const forms = tab.locator('form[data-live=check]');
  for (let k = 0; k < Math.min(await forms.count(), isWide ? Infinity : 1); k += 1) {
    const form = forms.nth(k);
    const where = `${page} check ${await form.getAttribute('data-name')} ${at}`;
    await ask(tab, form, where, isWide && k === 0).catch(error => faults.push(`${where}: ${error}`));
  }
  await context.close();
}

// Two at a time; in Firefox, only the page in front has the focus.
const work = async left => {
  while (left.length) await tryPage(...left.shift());
};
const wide = pages.map(page => [chrome, page, 1280]);
const [narrow, other] = [chrome, fox].map(browser => pages.map(page => [browser, page, 390]));
await Promise.all([work(wide), work(wide)]);
await Promise.all([work(narrow), work(other)]);
await Promise.all([chrome.close(), fox.close()]);
server.close();
faults.forEach(what => console.log(what));
console.log(`${pages.length} pages, ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
