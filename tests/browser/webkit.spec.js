// WebKit, by its own driver, as Playwright's build of it is no browser that anybody has: every
// figure becomes ready.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { pagesWithFigures } from './book.js';
import { expect, test as base } from './fixtures.js';

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  await once(server.close(), 'close');
  return port;
}

// A fixture `webkit`: a function that posts a command to the session of a browser.
const test = base.extend({
  webkit: [async ({}, use) => {
    const find = spawnSync('find', ['/usr/lib', '/usr/libexec', '-name', 'MiniBrowser'], { encoding: 'utf8' });
    const [binary] = find.stdout.split('\n');
    if (!binary) throw new Error('webkit2gtk-driver is missing: .ci/install installs it');
    const screen = spawn('Xvfb', ['-displayfd', '1'], { stdio: ['ignore', 'pipe', 'ignore'] });
    const display = `:${String(await once(screen.stdout, 'data')).trim()}`;
    const port = await freePort();
    const env = { ...process.env, DISPLAY: display };
    const driver = spawn('WebKitWebDriver', [`--port=${port}`], { stdio: 'ignore', env });
    const post = async (path, body) => {
      const url = `http://127.0.0.1:${port}/session${path}`;
      const { value } = await (await fetch(url, { method: 'POST', body: JSON.stringify(body) })).json();
      if (value?.error) throw new Error(value.message);
      return value;
    };
    const capabilities = { alwaysMatch: { 'webkitgtk:browserOptions': { binary, args: ['--automation'] } } };
    let session;
    await expect(async () => { session = await post('', { capabilities }); }).toPass({ timeout: 20_000 });
    await use((command, body) => post(`/${session.sessionId}/${command}`, body));
    [driver, screen].forEach(one => one.kill());
  }, { scope: 'worker' }],
});

// Brings figure after figure of a page into view; returns those that do not become ready.
const wake = async () => {
  const asleep = () => [...document.querySelectorAll('figure[data-live]:not([data-ready])')];
  for (let k = 0; k < 1000 && asleep().length; k += 1) {
    asleep()[0].scrollIntoView();
    await new Promise(done => setTimeout(done, 10));
  }
  return asleep().map(one => one.dataset.live);
};

for (const name of pagesWithFigures) {
  test(`${name}: every figure becomes ready`, async ({ webkit, served }) => {
    await webkit('url', { url: served + name });
    const asleep = await webkit('execute/async', { script: `(${wake})().then(arguments[0])`, args: [] });
    expect(asleep).toEqual([]);
  });
}
