// Nu's checker finds no fault in the HTML of any page.
import { execFile } from 'node:child_process';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { folder, pages } from './book.js';
import { expect, test } from './fixtures.js';

// It does not know two attributes of MathML Core and a property of CSS yet.
const UNKNOWN = /“(displaystyle|scriptlevel)” not allowed|“paint-order” doesn't exist/;

// It reads all pages at once, for the first test that asks.
test.describe.configure({ mode: 'default' });
let messages;
async function read() {
  const jar = createRequire(import.meta.url)('vnu-jar');
  const words = ['-jar', jar, '--format', 'json', '--exit-zero-always', ...pages.map(name => join(folder, name))];
  const { stderr } = await promisify(execFile)('java', words, { maxBuffer: 2 ** 28 });
  return JSON.parse(stderr).messages;
}

for (const name of pages) {
  test(`${name} is valid HTML`, async () => {
    messages ??= await read();
    const url = pathToFileURL(join(folder, name)).href.replace('file:///', 'file:/');
    const ours = messages.filter(one => one.url.replace('file:///', 'file:/') === url);
    const faults = ours.filter(({ type, message }) => type !== 'info' && !UNKNOWN.test(message));
    expect(faults.map(({ lastLine, message }) => `line ${lastLine}: ${message}`)).toEqual([]);
  });
}
