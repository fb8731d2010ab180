// The book as a careful web server gives it, on this machine alone: under a strict
// Content-Security-Policy.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { once } from 'node:events';
import { extname, join } from 'node:path';
import { folder } from './book.js';

const TYPES = { css: 'text/css', html: 'text/html; charset=utf-8', js: 'text/javascript', png: 'image/png', svg: 'image/svg+xml' };

export const POLICY = [
  `default-src 'none'`,
  // The modules are WebAssembly; a few lines of script and of style stand in the pages themselves.
  `script-src 'self' 'wasm-unsafe-eval' 'unsafe-inline'`,
  `style-src 'unsafe-inline'`,
  `img-src 'self'`,
  `font-src 'self'`,
  // `check` looks at a picture in a worker, whose few lines are in the page's own script.
  `worker-src blob:`,
  // 404.html has a base where the book is published in a folder of its server.
  `base-uri 'self'`,
  `require-trusted-types-for 'script'`,
].join('; ');

// Returns the server, which listens, and the address that it gives the book at, under a policy.
export async function serve(policy = POLICY) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://127.0.0.1');
    const bytes = await readFile(join(folder, pathname)).catch(() => null);
    const type = TYPES[extname(pathname).slice(1)] ?? 'application/octet-stream';
    response.writeHead(bytes ? 200 : 404, { 'content-security-policy': policy, 'content-type': type, 'x-content-type-options': 'nosniff' });
    response.end(bytes);
  });
  await once(server.listen(0, '127.0.0.1'), 'listening');
  return { server, address: `http://127.0.0.1:${server.address().port}/` };
}
