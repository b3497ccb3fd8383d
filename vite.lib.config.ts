import { defineConfig } from 'vite';
import project from './package.json' with { type: 'json' };

const external = Object.keys(project.dependencies);

/** The library: a file for each of its sources, so that a program's bundler leaves out what the program does not use. */
export default defineConfig({
  cacheDir: '.cache/vite',
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist/lib',
    minify: false,
    rolldownOptions: {
      external: (id) => external.some((name) => id === name || id.startsWith(`${name}/`)),
      output: {
        // As `const`, the tables of the CRC are constants to the engine too; the bundler's `var` costs a third of the speed.
        topLevelVar: false,
        preserveModules: true,
        preserveModulesRoot: 'src',
        entryFileNames: '[name].js',
      },
    },
    lib: { entry: ['src/framewright.ts', 'src/modbus/index.ts'], formats: ['es'] },
  },
});
