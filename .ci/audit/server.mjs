// Serves a folder as a web server does: texts are compressed, and everything may be kept.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';

const types = {
  '.css': 'text/css', '.html': 'text/html; charset=utf-8', '.js': 'text/javascript',
  '.png': 'image/png', '.svg': 'image/svg+xml', '.woff2': 'font/woff2',
};

// A server of the folder, and the address where it begins; to be closed.
export async function serve(folder) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    try {
      const bytes = readFileSync(join(folder, path));
      const isText = ['.css', '.html', '.js', '.svg'].includes(extname(path));
      response.writeHead(200, {
        'content-type': types[extname(path)] ?? 'application/octet-stream',
        'cache-control': 'max-age=31536000',
        ...(isText && { 'content-encoding': 'gzip' }),
      });
      response.end(isText ? gzipSync(bytes) : bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise(done => server.listen(0, done));
  return { home: `http://localhost:${server.address().port}/`, close: () => server.close() };
}
