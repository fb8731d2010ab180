// Every figure becomes ready in WebKit. The test runs an installed WebKit through WebKit's own
// driver, because nobody browses with Playwright's build of WebKit.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { figures } from './book.js';
import { expect, test } from './fixtures.js';

// Opens all folded boxes on a page, and scrolls its figures into view, one after the other. Returns
// the names of the figures that don't become ready.
const wake = async () => {
  document.querySelectorAll('details').forEach(box => { box.open = true; });
  const asleep = () => [...document.querySelectorAll('figure[data-live]:not([data-ready])')];
  for (let k = 0; k < 1000 && asleep().length; k += 1) {
    asleep()[0].scrollIntoView();
    await new Promise(done => setTimeout(done, 10));
  }
  return asleep().map(element => element.dataset.live);
};

test('every figure becomes ready', async ({ home }) => {
  test.setTimeout(300_000);
  const screen = spawn('Xvfb', ['-displayfd', '1'], { stdio: ['ignore', 'pipe', 'ignore'] });
  const DISPLAY = `:${String(await once(screen.stdout, 'data')).trim()}`;
  const driver = spawn('WebKitWebDriver', ['--port=4444'], { stdio: 'ignore', env: { ...process.env, DISPLAY } });
  // Posts a command to the driver, and returns the driver's reply.
  const post = async (path, body) => {
    const response = await fetch(`http://127.0.0.1:4444/session${path}`, { method: 'POST', body: JSON.stringify(body) });
    return (await response.json()).value;
  };
  let session;
  await expect(async () => { session = await post('', { capabilities: {} }); }).toPass({ timeout: 20_000 });
  for (const name of new Set(figures.map(([page]) => page))) {
    await post(`/${session.sessionId}/url`, { url: home + name });
    const asleep = await post(`/${session.sessionId}/execute/async`, { script: `(${wake})().then(arguments[0])`, args: [] });
    expect.soft(asleep, name).toEqual([]);
  }
  [driver, screen].forEach(process => process.kill());
});
