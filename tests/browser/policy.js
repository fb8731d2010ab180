// The strictest Content-Security-Policy under which all pages work: `npm run policy` prints it for
// the book that is built.
import { createHash } from 'node:crypto';
import { inline } from './book.js';

const hashes = tag => [...inline(tag)].map(text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`);

export const policy = [
  `default-src 'none'`,
  // The modules are WebAssembly.
  `script-src 'self' 'wasm-unsafe-eval' ${hashes('script').join(' ')}`,
  // Formulas, listings and handles have styles of their own in attributes, which have no hash.
  `style-src-elem ${hashes('style').join(' ')}`,
  `style-src-attr 'unsafe-inline'`,
  `img-src 'self'`,
  `font-src 'self'`,
  // `check` looks at a picture in a worker, whose few lines are in the page's own script.
  `worker-src blob:`,
  // 404.html has a base where the book is published in a folder of its server.
  `base-uri 'self'`,
  `form-action 'none'`,
  `frame-ancestors 'none'`,
].join('; ');

if (process.argv[1] === import.meta.filename) console.log(`Content-Security-Policy: ${policy}`);
