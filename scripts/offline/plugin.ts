import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const worker = fileURLToPath(new URL('worker.js', import.meta.url));
const hashOf = (what: string | Buffer): string => createHash('sha256').update(what).digest('hex');

/** Writes `offline-worker.js` into a folder: `worker.js`, and which files of the folder it is to keep, each with its hash. */
export function writeOfflineWorker(folder: string, names: readonly string[]): void {
  const files = names.toSorted().map((name) => {
    const address = name === 'index.html' ? './' : `./${name}`;
    return [address, hashOf(readFileSync(join(folder, name)))];
  });
  const rest = `const files = ${JSON.stringify(files)};\n${readFileSync(worker, 'utf8')}`;
  writeFileSync(join(folder, 'offline-worker.js'), `const version = '${hashOf(rest).slice(0, 12)}';\n${rest}`);
}

/** Lets the built page be kept for offline use. */
export function offline(): Plugin {
  let publicDir = '';
  return {
    name: 'offline',
    apply: 'build',
    configResolved(config) {
      publicDir = config.publicDir;
    },
    writeBundle: {
      order: 'post',
      handler({ dir = '' }, bundle) {
        const names = [...Object.keys(bundle), ...readdirSync(publicDir)];
        // Vite's own list of what is in which file.
        writeOfflineWorker(
          dir,
          names.filter((name) => name !== 'manifest.json'),
        );
      },
    },
  };
}
