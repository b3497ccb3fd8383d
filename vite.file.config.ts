import { defineConfig } from 'vite';
import { licences } from './scripts/licences.mjs';
import { oneFile } from './scripts/one-file/plugin.mjs';

/** The page as one file, which runs from a disk. `npm run build` comes first where both are wanted: it empties `dist`. */
export default defineConfig({
  cacheDir: '.cache/vite',
  publicDir: false,
  plugins: [licences(), oneFile('framewright.html')],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: false,
    reportCompressedSize: false,
    // As a library, since what the page loads later then comes without what fetches it.
    lib: { entry: 'scripts/one-file/entry.js', formats: ['iife'], name: 'framewright' },
    rolldownOptions: { output: { topLevelVar: false, codeSplitting: false } },
  },
});
