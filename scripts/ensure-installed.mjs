import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, runNpm } from './run.mjs';

const stamp = join(root, 'node_modules', '.framewright-installed');

/** Installs the locked dependencies, unless they are the ones installed already. Ends the process if that fails. */
export async function ensureInstalled() {
  const wanted = fingerprint();
  if (installed() === wanted) return;
  console.log('Installing dependencies (npm ci) …');
  const code = await runNpm(['ci', '--no-audit', '--no-fund']);
  if (code !== 0) {
    console.error('The dependencies could not be installed; see the messages of npm above.');
    process.exit(code);
  }
  writeFileSync(stamp, wanted);
}

/** What the installed files depend on: the lockfile, and the platform for which native parts were chosen. */
function fingerprint() {
  return createHash('sha256')
    .update(readFileSync(join(root, 'package-lock.json')))
    .update(`${process.platform} ${process.arch}`)
    .digest('hex');
}

function installed() {
  try {
    return readFileSync(stamp, 'utf8');
  } catch {
    return undefined;
  }
}
