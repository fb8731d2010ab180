// Serves the built book, and lets others judge it: Nu's checker every page, Lighthouse, as on a
// phone, the lightest page and two of the heaviest. Fails where a page is not HTML, or where
// Lighthouse wants more for anything but speed, which it tells and nothing fails on.
//
//     node judges.mjs FOLDER          (CHROMIUM names the browser)
import { launch } from 'chrome-launcher';
import lighthouse from 'lighthouse';
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import vnu from 'vnu-jar';
import { serve } from './server.mjs';

const folder = resolve(process.argv[2]);
const faults = new Set();

// It does not know two attributes of MathML Core and a property of CSS yet.
const pages = readdirSync(folder).filter(name => name.endsWith('.html'));
const own = /“(displaystyle|scriptlevel)” not allowed|“paint-order” doesn't exist/;
const nu = spawnSync('java', ['-jar', vnu, '--format', 'json', '--exit-zero-always',
  ...pages.map(page => join(folder, page))], { maxBuffer: 2 ** 28 });
if (nu.error) faults.add(`Nu's checker does not run: ${nu.error.message}`);
else {
  for (const { type, url, lastLine, message } of JSON.parse(nu.stderr).messages) {
    if (type !== 'info' && !own.test(message)) faults.add(`${url}, line ${lastLine}: ${message}`);
  }
}

const server = await serve(folder);
const browser = await launch({
  chromePath: process.env.CHROMIUM,
  chromeFlags: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-background-networking'],
});
for (const page of ['index', 'step01_rays', 'mistakes']) {
  const url = `${server.home}${page}.html`;
  const { lhr } = await lighthouse(url, { port: browser.port, logLevel: 'error' });
  const scores = Object.values(lhr.categories).map(({ id, score }) => [id, Math.round(100 * score)]);
  const shift = lhr.audits['cumulative-layout-shift'].numericValue;
  console.log(`${page}: ${scores.map(([id, score]) => `${id} ${score}`).join(', ')}, layout shift ${shift.toFixed(3)}`);
  for (const [id, score] of scores) {
    if (id !== 'performance' && score < 100) faults.add(`${page}: Lighthouse gives ${score} for ${id}`);
  }
  if (0.1 < shift) faults.add(`${page}: what is read moves while it loads, by ${shift.toFixed(3)}`);
}
browser.kill();
server.close();

for (const what of [...faults].sort()) console.log(what);
console.log(`${pages.length} pages judged, ${faults.size} faults`);
process.exit(faults.size ? 1 : 0);
