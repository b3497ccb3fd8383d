import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import page from '../../vite.config.ts';

const folder = fileURLToPath(new URL('.', import.meta.url));

/** The page of the benchmark, built as the real one is. */
export default defineConfig({
  base: './',
  root: folder,
  logLevel: 'warn',
  cacheDir: `${folder}/../../.cache/vite`,
  build: {
    target: page.build?.target ?? 'es2022',
    outDir: '../../.cache/bench-bus',
    emptyOutDir: true,
    rolldownOptions: { output: { topLevelVar: false } },
  },
  ...(page.worker && { worker: page.worker }),
});
