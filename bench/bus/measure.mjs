// Programs take turns, so that whatever else the machine does falls on all.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { openedChooser } from '../../tests/serial/harness/chooser.ts';
import { expect, test } from '../../tests/serial/harness/fixtures.ts';
import { quantile } from '../quantile.mjs';

const ROUNDS = 5;
const SECONDS = 2;
const PACED_SECONDS = 5;
/** Of modbus-webserial's rate, and of what the rules allow. */
const TARGETS = { peer: 0.8, rules: 0.9 };

const libmodbus = (tty) => {
  const program = join(process.env['FRAMEWRIGHT_SERIAL'], 'peer');
  return Number(execFileSync(program, ['rate', tty, '1', '10', String(SECONDS)], { encoding: 'utf8' }));
};

const number = (value) => value.toLocaleString('en', { maximumFractionDigits: value < 1000 ? 1 : 0 });
const row = (name, ...cells) => console.log(`  ${name.padEnd(58)}${cells.map((cell) => cell.padStart(12)).join('')}`);

async function choose(page) {
  await page.getByRole('button', { name: 'Choose a port' }).click();
  await (await openedChooser()).pick();
  await expect(page).toHaveTitle('chosen');
}
const measure = (page, name, options) => page.evaluate(([name, options]) => globalThis[name](options), [name, options]);

test('as fast as the cable', async ({ page, plugAdapter }) => {
  const { cable } = await plugAdapter();
  await choose(page);
  const rates = { ours: [], peer: [], libmodbus: [], ratio: [] };
  for (let round = 0; round < ROUNDS; round++) {
    const ours = await measure(page, 'ours', { baud: 115_200, gap: 0, seconds: SECONDS });
    const peer = await measure(page, 'modbusWebserial', { baud: 115_200, seconds: SECONDS });
    rates.ours.push(ours);
    rates.peer.push(peer);
    rates.ratio.push(ours / peer);
    rates.libmodbus.push(libmodbus(cable.port));
  }
  console.log('\nReading 10 registers from libmodbus over a pseudo-terminal, transactions a second');
  row('', 'median', 'best');
  const both = (values) => [quantile(values, 0.5), quantile(values, 1)].map(number);
  row('ours, without silences: decoded, checked and logged', ...both(rates.ours));
  row('modbus-webserial 0.10.1', ...both(rates.peer));
  row('libmodbus, a program in C on the same cable', ...both(rates.libmodbus));
  const ratio = quantile(rates.ratio, 0.5);
  const verdict = ratio >= TARGETS.peer ? 'met' : 'NOT MET';
  console.log(`  ${ratio.toFixed(2)} × modbus-webserial, target ${TARGETS.peer}: ${verdict}`);
});

for (const baud of [9600, 115_200]) {
  test(`at ${baud} baud`, async ({ page, plugAdapter }) => {
    await plugAdapter({ pace: true });
    await choose(page);
    const rate = await measure(page, 'ours', { baud, seconds: PACED_SECONDS });
    const most = await measure(page, 'allowed', { baud });
    const share = rate / most;
    console.log(`\nThe same over a cable that takes the time of ${baud} baud, 8E1, silences kept`);
    row('ours', number(rate));
    row('what characters and silences allow', number(most));
    const verdict = share >= TARGETS.rules ? 'met' : 'NOT MET';
    console.log(`  ${(100 * share).toFixed(0)} %, target ${100 * TARGETS.rules} %: ${verdict}`);
  });
}
