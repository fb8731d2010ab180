// Judges every page of the built book, for whoever looks after it, and fails where one has a fault:
//
//     node .ci/audit.mjs target/book
//
// Nu's checker reads every page; Chromium and Firefox open it, wide, narrow and dark, from a server
// and from the folder, and every live figure has to answer, in WebKit be ready; Lighthouse gives the
// three heaviest pages, or with LIGHTHOUSE=all each, 95 or more, speed apart. What this needs it installs,
// by apt-get and in target/audit.
import { execFile, execFileSync, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { gzipSync } from 'node:zlib';

const folder = resolve(process.argv[2]);
// 404.html is for a server's root, toc.html for browsers without scripts.
const pages = readdirSync(folder).filter(name => /\.html$/.test(name) && !/^(404|toc)\./.test(name));
const singles = pages.filter(name => name !== 'print.html');
const live = singles.filter(name => readFileSync(join(folder, name), 'utf8').includes(' data-live='));
const picture = name => readFileSync(join(folder, `pictures/${name}.png`), 'base64');
const run = promisify(execFile);
let count = 0;
const fault = (where, what) => { count += 1; console.log(`${where}: ${what}`); };

// What is missing comes first.
const which = (...names) => names
  .map(name => spawnSync('which', [name], { encoding: 'utf8' }).stdout.trim()).find(path => path);
function need(programs, packages) {
  const path = which(...programs);
  if (path) return path;
  const [first, ...words] = [which('sudo'), 'apt-get', '-qq'].filter(Boolean);
  spawnSync(first, [...words, 'update']);
  spawnSync(first, [...words, 'install', '--yes', '--no-install-recommends', ...packages]);
  return which(...programs);
}
const chrome = need(['chromium', 'google-chrome'], ['chromium', 'fonts-dejavu-core']);
const fox = need(['firefox-esr', 'firefox'], ['firefox-esr']);
need(['java'], ['default-jre-headless']);
const tools = resolve(import.meta.dirname, '../target/audit');
execFileSync('npm', ['install', '--prefix', tools, '--silent', '--no-audit', '--no-fund', '--no-save',
  'axe-core@4.14.1', 'lighthouse@12.8.2', 'playwright-core@1.64.0', 'vnu-jar@26.9.27']);
const installed = createRequire(join(tools, 'node_modules/'));
const { chromium, firefox } = installed('playwright-core');
const axe = readFileSync(installed.resolve('axe-core/axe.min.js'), 'utf8');
const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'];

// The book as a web server gives it: texts are compressed, and everything may be kept.
const types = { css: 'text/css', html: 'text/html; charset=utf-8', js: 'text/javascript', svg: 'image/svg+xml' };
const server = createServer((request, response) => {
  const path = join(folder, new URL(request.url, 'http://localhost').pathname);
  if (!existsSync(path)) return response.writeHead(404).end();
  const [type, bytes] = [types[extname(path).slice(1)], readFileSync(path)];
  response.setHeader('cache-control', 'max-age=31536000');
  if (!type) return response.end(bytes);
  return response.writeHead(200, { 'content-type': type, 'content-encoding': 'gzip' }).end(gzipSync(bytes));
});
await once(server.listen(0), 'listening');
const served = `http://localhost:${server.address().port}/`;
const local = `${pathToFileURL(folder).href}/`;

// The checker does not know two attributes of MathML Core and a property of CSS yet.
async function html() {
  const own = /“(displaystyle|scriptlevel)” not allowed|“paint-order” doesn't exist/;
  const words = ['-jar', installed('vnu-jar'), '--format', 'json', '--exit-zero-always'];
  const files = pages.map(page => join(folder, page));
  const { stderr } = await run('java', [...words, ...files], { maxBuffer: 2 ** 28 });
  for (const { type, url, lastLine, message } of JSON.parse(stderr).messages) {
    if (type !== 'info' && !own.test(message)) fault(url, `line ${lastLine}: ${message}`);
  }
}

// Every page in one kind of view; what is live is tried where `isTried`.
async function view(browser, home, width, colorScheme, isTried) {
  const [isChrome, isWide, isDark] = [browser === blink, width === 1280, colorScheme === 'dark'];
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
  const tab = await context.newPage();
  let page;
  // Firefox says so of a formula that is drawn before all of it has come.
  const fail = what => /Incorrect number of children for <m/.test(what)
    || fault(`${page} (${browser.browserType().name()}, ${width} px, ${colorScheme})`, what);
  tab.on('console', message => message.type() === 'error' && fail(message.text()));
  tab.on('pageerror', error => fail(String(error)));
  const own = [home, 'data:', 'blob:'];
  tab.on('request', one => own.some(start => one.url().startsWith(start)) || fail(`asks for ${one.url()}`));
  for (page of pages) {
    await tab.goto(home + page);
    await tab.waitForFunction(() => window.search); // It comes last.
    // What is folded away or far below is looked at as well, and no picture is left for later.
    const [sideways, broken] = await tab.evaluate(async () => {
      document.querySelectorAll('details').forEach(box => { box.open = true; });
      document.querySelectorAll('main > *').forEach(part => { part.style.contentVisibility = 'visible'; });
      const [root, pictures] = [document.documentElement, [...document.images]];
      pictures.forEach(one => { one.loading = 'eager'; });
      await Promise.all(pictures.map(one => one.decode().catch(() => {})));
      const broken = pictures.filter(one => one.naturalWidth === 0).map(one => one.src);
      return [root.scrollWidth - root.clientWidth, broken];
    });
    if (1 < sideways) fail(`scrolls sideways by ${sideways} px`);
    broken.forEach(source => fail(`shows no picture for ${source}`));
    // What axe finds in the pages it would find in all of them again.
    if (isChrome && page !== 'print.html') {
      await tab.evaluate(axe);
      // Nothing but colours depends on dark, and little on the width.
      const narrow = isWide ? undefined : ['scrollable-region-focusable', 'target-size'];
      const options = { preload: false, runOnly: isDark ? ['color-contrast'] : narrow };
      const { violations } = await tab.evaluate(chosen => window.axe.run(chosen), options);
      violations.forEach(({ id, help, nodes }) => fail(`${id}: ${help}, at ${nodes[0].target}`));
    }
    if (!isTried || !live.includes(page)) continue;
    for (const figure of await tab.locator('figure[data-live]').all()) {
      await answers(tab, figure, isWide, fail).catch(error => fail(String(error)));
    }
    for (const form of (await tab.$$('form[data-live=check]')).slice(0, isWide ? 99 : 1)) {
      const named = await form.getAttribute('data-name');
      const name = named === '*' ? 'step04_diffuse' : named;
      const right = await form.evaluate(drop, [picture(name), `${name}.png`]);
      const wrong = await form.evaluate(drop, [picture('shadowed'), `${name}.png`]);
      if (!right.startsWith('Right')) fail(`says of the right picture of ${name}: ${right}`);
      if (/^(Right|Looking|This page|$)/.test(wrong)) fail(`says of a wrong ${name}: ${wrong}`);
    }
  }
  await tab.keyboard.press('s'); // The search finds something, without a server, too.
  await tab.keyboard.type('discriminant');
  const found = tab.locator('#mdbook-searchresults a').first();
  await found.waitFor({ timeout: 5000 }).catch(() => fail('the search finds nothing'));
  await context.close();
}

// A figure changes by its handles and knobs, or its first handle; reset brings back what is printed.
async function answers(tab, figure, isWide, fail) {
  const name = await figure.getAttribute('data-live');
  await figure.scrollIntoViewIfNeeded();
  await figure.and(tab.locator('[data-ready]')).waitFor({ timeout: 10000 });
  const seen = async () => {
    await tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    return figure.evaluate(one => one.querySelector('svg')?.innerHTML + JSON.stringify([
      ...[...one.querySelectorAll('canvas')].map(canvas => canvas.toDataURL()),
      ...[...one.querySelectorAll('.handle')].map(handle => handle.style.cssText)]));
  };
  const reset = figure.locator('.reset');
  await reset.evaluate(one => { one.disabled = false; one.click(); }); // Now all is drawn.
  const printed = await seen();
  const moved = async how => {
    if (await seen() === printed) fail(`${name} does not change by ${how}`);
    if (await reset.isDisabled()) return;
    await reset.click();
    if (await seen() !== printed) fail(`${name} is not as printed after ${how} and reset`);
  };
  for (const handle of (await figure.locator('.handle:visible').all()).slice(0, isWide ? 99 : 1)) {
    await handle.hover();
    const { x, y } = await handle.boundingBox();
    await tab.mouse.down();
    await tab.mouse.move(x + 25, y - 15, { steps: 3 });
    await tab.mouse.up();
    await moved(`dragging ${await handle.getAttribute('aria-label')}`);
  }
  const knobs = figure.locator('.knobs [data-knob] :is(input, select):visible');
  for (const knob of isWide ? await knobs.all() : []) {
    await knob.focus();
    await tab.keyboard.press(await knob.evaluate(({ type, value, min }) => ({
      checkbox: 'Space', range: value === min ? 'ArrowRight' : 'ArrowLeft',
    })[type] ?? 'ArrowDown'));
    await moved(`a key on ${await knob.locator('..').textContent()}`);
  }
}

// What a form in a page says of a picture that is dropped on it.
const drop = async (form, [bytes, name]) => {
  const output = form.querySelector('output');
  form.querySelector('button').click();
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([Uint8Array.from(atob(bytes), one => one.charCodeAt(0))], name));
  form.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  while (/^(Looking|$)/.test(output.textContent)) await new Promise(done => setTimeout(done, 20));
  return output.textContent;
};

// Brings figure after figure of a page into view; returns those that do not become ready.
const wake = async () => {
  const asleep = () => [...document.querySelectorAll('figure[data-live]:not([data-ready])')];
  for (let k = 0; k < 1000 && asleep().length; k += 1) {
    asleep()[0].scrollIntoView();
    await new Promise(done => setTimeout(done, 10));
  }
  return asleep().map(one => one.dataset.live);
};

// WebKit, by its driver: the browser is MiniBrowser, and its screen is Xvfb's.
async function webkit() {
  const isDriven = need(['WebKitWebDriver'], ['webkit2gtk-driver']) && need(['Xvfb'], ['xvfb']);
  const find = spawnSync('find', ['/usr/lib', '/usr/libexec', '-name', 'MiniBrowser']);
  const binary = String(find.stdout).split('\n')[0];
  if (!isDriven || !binary) return console.log('no webkit2gtk-driver or xvfb here: WebKit is left out');
  const screen = spawn('Xvfb', ['-displayfd', '1'], { stdio: ['ignore', 'pipe', 'ignore'] });
  const env = { ...process.env, DISPLAY: `:${String(await once(screen.stdout, 'data')).trim()}` };
  const port = 20000 + process.pid % 20000;
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], { stdio: 'ignore', env });
  process.on('exit', () => [driver, screen].forEach(one => one.kill()));
  await new Promise(done => setTimeout(done, 1000));
  const ask = async (path, body) => {
    const url = `http://127.0.0.1:${port}/session${path}`;
    const { value } = await (await fetch(url, { method: 'POST', body: JSON.stringify(body) })).json();
    if (value?.error) throw new Error(value.message);
    return value;
  };
  const options = { 'webkitgtk:browserOptions': { binary, args: ['--automation'] } };
  const { sessionId } = await ask('', { capabilities: { alwaysMatch: options } });
  const script = `(${wake})().then(arguments[0])`;
  for (const url of [served, local].flatMap(home => live.map(page => home + page))) {
    await ask(`/${sessionId}/url`, { url });
    const asleep = await ask(`/${sessionId}/execute/async`, { script, args: [] });
    asleep.forEach(name => fault(`${url} (WebKit)`, `${name} does not become ready`));
  }
}

// Lighthouse, page after page. Its speed is told, and judged by who reads it: it is as noisy as the machine.
async function phone(chosen) {
  const program = join(tools, 'node_modules/.bin/lighthouse');
  const words = ['--quiet', '--output=json', `--chrome-flags=--headless ${flags.join(' ')}`];
  const options = { maxBuffer: 2 ** 28, env: { ...process.env, CHROME_PATH: chrome } };
  for (const page of chosen) {
    const { stdout } = await run(program, [served + page, ...words], options);
    for (const { id, score } of Object.values(JSON.parse(stdout).categories)) {
      if (id === 'performance') console.log(`${page}: Lighthouse gives ${score} for speed`);
      else if (score < 0.95) fault(page, `Lighthouse gives ${score} for ${id}`);
    }
  }
}

const blink = await chromium.launch({ executablePath: chrome, args: flags });
const gecko = await firefox.launch({ channel: 'moz-firefox', executablePath: fox });
const inTurn = async (...parts) => { for (const part of parts) await part(); };
await Promise.all([inTurn(
  () => view(blink, served, 1280, 'light', true),
  () => view(blink, local, 390, 'light', false),
  () => view(blink, local, 1280, 'dark', false),
), inTurn(
  html, webkit,
  () => view(gecko, local, 390, 'light', true),
  () => view(gecko, served, 1280, 'dark', false),
)]);
await Promise.all([blink.close(), gecko.close()]);
const heaviest = ['step01_rays.html', 'step04_diffuse.html', 'step05_phong.html'];
await phone(process.env.LIGHTHOUSE === 'all' ? singles : heaviest);
console.log(`${pages.length} pages, ${count} faults in ${Math.round(performance.now() / 1000)} s`);
process.exit(count ? 1 : 0);
