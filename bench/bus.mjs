// `npm run bench:bus`: transactions a second through the real Web Serial API, ours and others'. A page of its own is built
// for it, and runs where serial ports can be plugged in.

import { join } from 'node:path';
import { build } from 'vite';
import { root, run } from '../scripts/run.mjs';
import { howToGetASerialRig, inNamespaces, prepareSerialRig, serialEnvironment } from '../scripts/serial-rig.mjs';

await build({
  configFile: false,
  root,
  logLevel: 'warn',
  publicDir: false,
  build: { ssr: 'bench/bus/processor.mjs', outDir: '.cache/bench-bus-processor' },
});
const { processorTime, PARTS, MOST } = await import(join(root, '.cache/bench-bus-processor/processor.js'));
const { of, sum } = await processorTime();
console.log(
  `Own processor time of a transaction: ${sum.toFixed(1)} µs (${PARTS.map((part, at) => `${part} ${of[at].toFixed(1)}`).join(', ')}); target ${MOST}: ${sum <= MOST ? 'met' : 'NOT MET'}`,
);

const missing = await prepareSerialRig();
if (missing !== undefined) {
  console.error(`${missing}\n${howToGetASerialRig}`);
  process.exit(2);
}
await build({ configFile: join(root, 'bench', 'bus', 'vite.config.ts') });
const [command, args] = inNamespaces([
  process.execPath,
  'node_modules/@playwright/test/cli.js',
  'test',
  '--config=bench/bus/playwright.config.ts',
]);
process.exitCode = await run(command, args, { env: serialEnvironment });
