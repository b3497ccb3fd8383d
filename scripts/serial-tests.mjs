// `npm run serial`: the tests against the real Web Serial API, or why they cannot run here.

import { buildKnown } from './known.mjs';
import { run } from './run.mjs';
import { howToGetASerialRig, inNamespaces, prepareSerialRig, serialEnvironment } from './serial-rig.mjs';

const missing = await prepareSerialRig();
if (missing !== undefined) {
  console.error(`SERIAL TESTS NOT RUN. ${missing}\n${howToGetASerialRig}`);
  process.exit(2);
}
const [command, args] = inNamespaces([
  process.execPath,
  'node_modules/@playwright/test/cli.js',
  'test',
  '--config=playwright.serial.config.ts',
  ...process.argv.slice(2),
]);
process.exitCode = await run(command, args, { env: { ...serialEnvironment, ...(await buildKnown()) } });
