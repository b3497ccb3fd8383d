import { fileURLToPath } from 'node:url';
import { defineConfig } from '@playwright/test';
import base from '../../playwright.serial.config.ts';

/** The network is this run's own, so that any port is free. */
const PORT = 43947;

export default defineConfig({
  ...base,
  testDir: '.',
  outputDir: '../../.cache/playwright-bench',
  testMatch: 'measure.mjs',
  timeout: 180_000,
  reporter: [['line']],
  use: { ...base.use, baseURL: `http://127.0.0.1:${PORT}/` },
  webServer: {
    command: `npx vite preview --config bench/bus/vite.config.ts --host 127.0.0.1 --port ${PORT} --strictPort`,
    cwd: fileURLToPath(new URL('../..', import.meta.url)),
    url: `http://127.0.0.1:${PORT}/`,
    reuseExistingServer: false,
  },
});
