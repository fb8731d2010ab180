// The book as a careful web server gives it, on this machine alone: compressed, and to be kept.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { once } from 'node:events';
import { extname, join } from 'node:path';
import { promisify } from 'node:util';
import { gzip } from 'node:zlib';
import { folder } from './book.js';

const TYPES = { css: 'text/css', html: 'text/html; charset=utf-8', js: 'text/javascript', svg: 'image/svg+xml' };

// Returns the server, which listens, and the address that it gives the book at; it sends the policy,
// if there is one, with every file.
export async function serve(policy) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://127.0.0.1');
    const bytes = await readFile(join(folder, pathname)).catch(() => null);
    if (!bytes) return response.writeHead(404).end();
    const type = TYPES[extname(pathname).slice(1)];
    response.setHeader('cache-control', 'max-age=31536000');
    if (policy) response.setHeader('content-security-policy', policy);
    response.setHeader('x-content-type-options', 'nosniff');
    if (!type) return response.end(bytes);
    response.writeHead(200, { 'content-type': type, 'content-encoding': 'gzip' });
    return response.end(await promisify(gzip)(bytes));
  });
  await once(server.listen(0, '127.0.0.1'), 'listening');
  return { server, address: `http://127.0.0.1:${server.address().port}/` };
}
