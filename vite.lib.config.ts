import { defineConfig } from 'vite';

export default defineConfig({
  cacheDir: '.cache/vite',
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist/lib',
    minify: false,
    lib: { entry: 'src/framewright.ts', formats: ['es'], fileName: 'framewright' },
  },
});
