// Lighthouse on the three heaviest pages, or on those that are named: `npm run lighthouse`. It is
// run by hand, as it takes minutes and brings 150 packages, and its speed depends on the machine.
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { serve } from './server.js';

const named = process.argv.slice(2);
const pages = named.length ? named : ['step01_rays.html', 'step04_diffuse.html', 'step05_phong.html'];
// Without the policy, which keeps Lighthouse from looking for a robots.txt.
const { server, address } = await serve();
for (const page of pages) {
  const { stdout } = await promisify(execFile)('npx', [
    '--yes', 'lighthouse@12.8.2', address + page, '--quiet', '--output=json',
    '--chrome-flags=--headless --no-sandbox --disable-gpu',
  ], { maxBuffer: 2 ** 28 });
  for (const { id, score } of Object.values(JSON.parse(stdout).categories)) {
    const isLow = id !== 'performance' && score < 0.95;
    if (isLow) process.exitCode = 1;
    console.log(`${page}: ${score} for ${id}${isLow ? ', less than 0.95' : ''}`);
  }
}
server.close();
