// The built page as a static host serves it. `node scripts/static-server.mjs PORT` does so until it is ended.
import { readdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { root } from './run.mjs';

const types = new Map([
  ['.html', 'text/html; charset=utf-8'],
  ['.js', 'text/javascript; charset=utf-8'],
  ['.css', 'text/css; charset=utf-8'],
  ['.svg', 'image/svg+xml'],
  ['.json', 'application/json'],
  ['.webmanifest', 'application/manifest+json'],
  ['.txt', 'text/plain; charset=utf-8'],
]);

/**
 * Serves what is in dist/ now: another build may come meanwhile.
 * @param {{ port?: number, compressed?: boolean, refused?: ReadonlySet<string> }} [how] with port 0 any that is free; what is refused
 *   comes later
 * @returns {Promise<{ address: string, close: () => void }>} from `close` on it answers nobody any more
 */
export async function serveBuiltPage({ port = 0, compressed = false, refused = new Set() } = {}) {
  const dist = join(root, 'dist');
  const files = new Map(
    readdirSync(dist, { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map(({ parentPath, name }) => {
        const path = join(parentPath, name);
        const content = readFileSync(path);
        const body = compressed ? gzipSync(content, { level: 9 }) : content;
        return /** @type {const} */ ([relative(dist, path).replaceAll('\\', '/'), body]);
      }),
  );
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname.slice(1) || 'index.html';
    const body = files.get(path);
    if (body === undefined || refused.has(path)) {
      response.writeHead(body ? 503 : 404).end();
      return;
    }
    response.writeHead(200, {
      'content-type': types.get(extname(path)) ?? 'application/octet-stream',
      ...(compressed && { 'content-encoding': 'gzip' }),
      // The names of assets come from their content.
      'cache-control': path.startsWith('assets/') ? 'public, max-age=31536000, immutable' : 'no-cache',
    });
    response.end(request.method === 'HEAD' ? undefined : body);
  });
  await new Promise((done, fail) => server.once('error', fail).listen(port, '127.0.0.1', () => done(undefined)));
  const taken = server.address();
  if (taken === null || typeof taken === 'string') throw new Error('The built page is not served.');
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { address: `http://127.0.0.1:${taken.port}/`, close };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await serveBuiltPage({ port: Number(process.argv[2]) });
