// The built page as a web host serves it, compressed, and a browser to open it in.
import { execFileSync } from 'node:child_process';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer as createViteServer } from 'vite';
import { findBrowserWithoutWindows, findInstalledBrowser } from '../scripts/find-browser.mjs';
import { root } from '../scripts/run.mjs';
import { serveBuiltPage } from '../scripts/static-server.mjs';

/** Builds the page, unless BUILT=1 says that it is built, and serves it. Answers its address and how to end that. */
export async function servePage() {
  if (process.env.BUILT !== '1') {
    execFileSync('npm', ['run', 'build'], { stdio: 'ignore', shell: process.platform === 'win32' });
  }
  return serveBuiltPage({ compressed: true });
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
