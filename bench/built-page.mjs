// The built page as a web host serves it, compressed, and a browser to open it in.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { loadavg } from 'node:os';
import { extname, join, relative } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium } from '@playwright/test';
import { createServer as createViteServer } from 'vite';
import { findBrowserWithoutWindows, findInstalledBrowser } from '../scripts/find-browser.mjs';
import { root } from '../scripts/run.mjs';

const types = new Map([
  ['.html', 'text/html; charset=utf-8'],
  ['.js', 'text/javascript; charset=utf-8'],
  ['.css', 'text/css; charset=utf-8'],
  ['.svg', 'image/svg+xml'],
  ['.json', 'application/json'],
  ['.webmanifest', 'application/manifest+json'],
  ['.txt', 'text/plain; charset=utf-8'],
]);

/** Builds the page, unless BUILT=1 says that it is built, and serves it. Answers its address and how to end that. */
export async function servePage() {
  if (process.env.BUILT !== '1') {
    execFileSync('npm', ['run', 'build'], { stdio: 'ignore', shell: process.platform === 'win32' });
  }
  const dist = join(root, 'dist');
  // All of it now: another build may come while this one is measured.
  const paths = readdirSync(dist, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = new Map(
    paths.map(({ parentPath, name }) => {
      const path = join(parentPath, name);
      return [relative(dist, path).replaceAll('\\', '/'), gzipSync(readFileSync(path), { level: 9 })];
    }),
  );
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname.slice(1) || 'index.html';
    const file = files.get(path);
    if (file === undefined) return response.writeHead(404).end();
    response.writeHead(200, {
      'content-type': types.get(extname(path)) ?? 'application/octet-stream',
      'content-encoding': 'gzip',
      // The names of assets come from their content.
      'cache-control': path.startsWith('assets/') ? 'public, max-age=31536000, immutable' : 'no-cache',
    });
    response.end(file);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/**
 * @param {{ windows?: boolean, args?: string[] }} [how] with windows, for what a browser without them measures differently
 */
export function launch({ windows = false, args = [] } = {}) {
  const executablePath = windows ? findInstalledBrowser() : findBrowserWithoutWindows();
  return chromium.launch({
    ...(executablePath && { executablePath }),
    args: [
      ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
      '--disable-background-networking',
      '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup',
      ...args,
    ],
  });
}

/**
 * The words of the page in English, by subject, so that what is looked for has the name that the page gives it; and what
 * finds faults of the layout.
 */
export async function modulesOfThePage() {
  const modules = await createViteServer({
    root,
    configFile: false,
    logLevel: 'silent',
    appType: 'custom',
    cacheDir: join(root, '.cache/vite-bench'),
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, ws: false, watch: null },
  });
  try {
    const { languages } = await modules.ssrLoadModule('/src/words/index.ts');
    const subjects = Object.entries(languages.en).map(async ([subject, load]) => [subject, await load()]);
    const words = Object.fromEntries(await Promise.all(subjects));
    const { layoutFaults } = await modules.ssrLoadModule('/tests/browser/layout-faults.ts');
    return { words, layoutFaults };
  } finally {
    await modules.close();
  }
}

/** The work that waits for a processor, of the last minute. */
export const load = () => loadavg()[0] ?? 0;

/**
 * Waits until the machine has little else to do.
 * @returns {Promise<boolean>} whether it has
 */
export async function waitForCalm(most = 0.5, seconds = Number(process.env.WAIT ?? 120)) {
  const end = Date.now() + seconds * 1000;
  while (load() >= most && Date.now() < end) await new Promise((done) => setTimeout(done, 2000));
  return load() < most;
}

/** Prints rows of texts in columns. */
export function printTable(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => String(row[column] ?? '').length)));
  for (const row of rows)
    console.log(
      row
        .map((cell, column) => String(cell ?? '').padEnd(widths[column]))
        .join('  ')
        .trimEnd(),
    );
}
