// `npm run browser`: the tests of the page in a browser, on the page as last built.
import { buildKnown } from './known.mjs';
import { run } from './run.mjs';

const args = ['node_modules/@playwright/test/cli.js', 'test', ...process.argv.slice(2)];
process.exitCode = await run(process.execPath, args, { env: await buildKnown() });
