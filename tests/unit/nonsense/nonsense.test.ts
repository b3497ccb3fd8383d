import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { beforeAll, expect, test } from 'vitest';
import type { Order, Report, Said } from './order.ts';

/** Calls of each function. */
const CALLS = 20;
/** Another seed makes other calls. */
const SEED = Number(process.env['FRAMEWRIGHT_SEED'] ?? 1);
/** Milliseconds for one call. It may take a second of the processor, which may have other work to do. */
const PATIENCE = 60_000;
/** Megabytes. A call that needs more ends the process. */
const MEMORY = 512;

let script: string;

beforeAll(async () => {
  const entry = fileURLToPath(new URL('./caller.ts', import.meta.url));
  const built = await build({
    configFile: false,
    logLevel: 'error',
    ssr: { noExternal: true },
    build: { write: false, minify: false, target: 'es2022', ssr: entry },
  });
  const [bundle] = [built].flat();
  script = (bundle && 'output' in bundle && bundle.output[0].code) || '';
});

/** What a process of its own says of the calls; a call that does not end is ended with the process. */
function run(order: Order): Promise<Report | { readonly stuck: number; readonly call: string; readonly why: string }> {
  const child = spawn(
    process.execPath,
    [`--max-old-space-size=${MEMORY}`, '--input-type=module', '-', JSON.stringify(order)],
    { stdio: ['pipe', 'pipe', 'ignore'] },
  );
  child.stdin.end(script);
  return new Promise((done) => {
    let [text, at, call, why] = ['', -1, '', 'the process ended'];
    let report: Report | undefined;
    const lose = () => {
      why = 'it does not end';
      child.kill('SIGKILL');
    };
    let patience = setTimeout(lose, PATIENCE);
    child.stdout.setEncoding('utf8').on('data', (chunk: string) => {
      clearTimeout(patience);
      patience = setTimeout(lose, PATIENCE);
      const lines = (text + chunk).split('\n');
      text = lines.pop() ?? '';
      for (const line of lines) {
        const said: Said = JSON.parse(line);
        if (typeof said === 'number') at = said;
        else if (typeof said === 'string') call = said;
        else report = said;
      }
    });
    child.on('close', () => {
      clearTimeout(patience);
      done(report ?? { stuck: at, call, why });
    });
  });
}

test('every exported function answers nonsense, or throws a typed error', async () => {
  const order = { calls: CALLS, seed: SEED, explain: -1 };
  const said = await run(order);
  if ('stuck' in said) {
    const again = await run({ ...order, explain: said.stuck });
    expect.fail(`${said.why}: ${'call' in again ? again.call : `call ${said.stuck}`}`);
  }
  expect(said.complaints).toEqual([]);
  for (const name of ['library.decodeFrame', 'sequences.readSequences', 'workbench.readLink'])
    expect(said.functions).toContain(name);
});
