import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium } from '@playwright/test';
import { root } from './run.mjs';
import { serveBuiltPage } from './static-server.mjs';

/** Bytes, gzipped, that an untouched page may have loaded after so many milliseconds. */
const budget = 75_000;
const after = 6000;

/**
 * Weighs everything the built page has loaded some seconds after it was opened, though nobody touched it. Tells a row a
 * file.
 * @param {(text: string) => void} tell
 * @param {string} executablePath the browser's program
 * @returns {Promise<boolean>} whether it keeps to the budget
 */
export async function sizeFits(tell, executablePath) {
  const files = await loadedFiles(executablePath);
  const sizes = files.map((file) => gzipSync(readFileSync(join(root, 'dist', file)), { level: 9 }).length);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  files.forEach((file, index) => {
    tell(`  ${kilobytes(sizes[index] ?? 0)}  ${file}\n`);
  });
  const fits = total <= budget;
  const verdict = fits ? '' : ': TOO BIG';
  tell(`  ${kilobytes(total)}  loaded untouched, gzipped, of at most ${kilobytes(budget).trim()}${verdict}\n`);
  return fits;
}

/**
 * The files of the built page that a browser asks for, each once.
 * @param {string} executablePath
 */
async function loadedFiles(executablePath) {
  const { address, close } = await serveBuiltPage();
  const asRoot = process.getuid?.() === 0;
  const browser = await chromium.launch({
    executablePath,
    args: asRoot ? ['--no-sandbox'] : [],
  });
  try {
    const context = await browser.newContext();
    /** @type {Set<string>} */
    const files = new Set();
    context.on('request', (request) => {
      // What the worker for offline use keeps afterwards delays nothing.
      if (!request.url().startsWith(address) || request.serviceWorker() !== null) return;
      files.add(new URL(request.url()).pathname.slice(1) || 'index.html');
    });
    const page = await context.newPage();
    await page.goto(address);
    await page.waitForTimeout(after);
    if (![...files].some((file) => file.endsWith('.js'))) throw new Error('The built page loads no script at all.');
    return [...files];
  } finally {
    await browser.close();
    close();
  }
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(2).padStart(6)} kB`;
}
