import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { extname, join, resolve } from 'node:path';
import { writeOfflineWorker } from '../../scripts/offline/plugin.ts';

const types: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.webmanifest': 'application/manifest+json',
};

/** How a file comes, other than it is: not at all, without its end, or with another byte in it. */
export type Broken = 'missing' | 'cut' | 'changed';

/** A host of the built page, of which a test serves other versions, and breaks files. */
export class PageServer {
  readonly #folder = mkdtempSync(join(tmpdir(), 'framewright-'));
  readonly #server: Server;
  readonly broken = new Map<string, Broken>();
  /** The names of the files that came. */
  readonly came = new Set<string>();
  /** What was asked for with another method than GET. */
  readonly sent: string[] = [];

  constructor() {
    for (const entry of readdirSync('dist', { withFileTypes: true })) {
      if (entry.isFile() && entry.name !== 'framewright.html')
        copyFileSync(join('dist', entry.name), join(this.#folder, entry.name));
    }
    // No version has other scripts and styles.
    symlinkSync(resolve('dist/assets'), join(this.#folder, 'assets'), 'junction');
    this.publish('first');
    this.#server = createServer(({ method, url = '' }, response) => {
      if (method !== 'GET') this.sent.push(`${method} ${url}`);
      const name = new URL(url, 'http://host/').pathname.slice(1) || 'index.html';
      const how = this.broken.get(name);
      try {
        const bytes = readFileSync(join(this.#folder, name));
        if (how === 'missing') throw new Error('missing');
        response.writeHead(200, {
          'content-type': types[extname(name)] ?? 'text/plain',
          'content-length': bytes.length,
        });
        if (how === 'changed') bytes[bytes.length - 3]! ^= 1;
        if (how !== 'cut') response.end(bytes);
        else response.write(bytes.subarray(0, -20), () => response.destroy());
        this.came.add(name);
      } catch {
        response.writeHead(404).end();
      }
    });
  }

  /** Its address, from when it is served. */
  async start(): Promise<string> {
    await new Promise<void>((resolve) => this.#server.listen(0, '127.0.0.1', resolve));
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}/`;
  }

  stop(): void {
    this.#server.closeAllConnections();
    this.#server.close();
    rmSync(this.#folder, { recursive: true });
  }

  /** The names of the files that a browser is to keep. */
  get files(): string[] {
    const text = readFileSync(join(this.#folder, 'offline-worker.js'), 'utf8');
    const list = JSON.parse(/^const files = (.*);$/m.exec(text)?.[1] ?? '') as [string, string][];
    return list.map(([address]) => (address === './' ? 'index.html' : address.slice(2)));
  }

  /** Serves another version from now on, whose document says which it is, and of which a browser is to keep these files. */
  publish(version: string, files: readonly string[] = this.files): void {
    const path = join(this.#folder, 'index.html');
    const html = readFileSync(path, 'utf8');
    writeFileSync(path, html.replace(/<html[^>]*>/, `<html lang="en" data-version="${version}">`));
    writeOfflineWorker(this.#folder, files);
  }
}
