// A server for the book, reachable only from this machine. Like a careful server on the web, it
// sends a strict Content-Security-Policy.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { once } from 'node:events';
import { extname, join } from 'node:path';
import { folder } from './book.js';

const TYPES = { css: 'text/css', html: 'text/html; charset=utf-8', js: 'text/javascript', png: 'image/png', svg: 'image/svg+xml' };

export const POLICY = [
  `default-src 'none'`,
  // The modules are WebAssembly, and the pages contain a few lines of inline script and style.
  `script-src 'self' 'wasm-unsafe-eval' 'unsafe-inline'`,
  `style-src 'unsafe-inline'`,
  `img-src 'self'`,
  `font-src 'self'`,
  // `check` runs in a worker. The worker's few lines of code are a string in the page's own script.
  `worker-src blob:`,
  // 404.html has a `<base>` if the book is published in a subfolder of a server.
  `base-uri 'self'`,
  `require-trusted-types-for 'script'`,
].join('; ');

// Starts a server with this policy. Returns the server and the book's address.
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
