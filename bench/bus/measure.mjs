// Programs take turns, so that whatever else the machine does falls on all.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { openedChooser } from '../../tests/serial/harness/chooser.ts';
import { expect, test } from '../../tests/serial/harness/fixtures.ts';
import { quantile } from '../quantile.mjs';

const BAUD = 115_200;
const ROUNDS = 6;
const SECONDS = 1.5;
/** Milliseconds. In the fastest tenth of such pieces a program was nearly alone. */
const PIECE = 50;
const PACED_SECONDS = 5;
/** A share of modbus-webserial's rate, and percent of what the rules allow. */
const TARGETS = { peer: 0.8, rules: 90 };

const libmodbus = (tty) => {
  const program = join(process.env['FRAMEWRIGHT_SERIAL'], 'peer');
  // A pseudo-terminal has no parity: the C library reports this unless something else has changed.
  execFileSync('stty', ['-F', tty, '1200']);
  return Number(execFileSync(program, ['rate', tty, '1', '10', String(SECONDS)], { encoding: 'utf8' }));
};

const number = (value) => value.toLocaleString('en', { maximumFractionDigits: value < 1000 ? 2 : 0 });
const row = (name, ...cells) => console.log(`  ${name.padEnd(58)}${cells.map((cell) => cell.padStart(12)).join('')}`);

async function choose(page) {
  await page.getByRole('button', { name: 'Choose a port' }).click();
  await (await openedChooser()).pick();
  await expect(page).toHaveTitle('chosen');
}
const measure = (page, name, options) => page.evaluate(([name, options]) => globalThis[name](options), [name, options]);

/** Transactions a second in each piece of so many milliseconds, of the times at which they ended. */
function ratesOf(times) {
  const counts = new Map();
  for (const time of times) {
    const piece = Math.floor((time - times[0]) / PIECE);
    counts.set(piece, (counts.get(piece) ?? 0) + 1);
  }
  const pieces = Math.floor((times.at(-1) - times[0]) / PIECE);
  return Array.from({ length: pieces }, (_, piece) => ((counts.get(piece) ?? 0) * 1000) / PIECE);
}

test('as fast as the cable', async ({ page, plugAdapter }) => {
  const { cable } = await plugAdapter();
  await choose(page);
  const rates = { ours: [], peer: [], libmodbus: [] };
  for (let round = 0; round < ROUNDS; round++) {
    rates.ours.push(...ratesOf(await measure(page, 'ours', { baud: BAUD, gap: 0, seconds: SECONDS })));
    rates.peer.push(...ratesOf(await measure(page, 'modbusWebserial', { baud: BAUD, seconds: SECONDS })));
    rates.libmodbus.push(libmodbus(cable.port));
  }
  console.log('\nReading 10 registers from libmodbus over a pseudo-terminal, transactions a second');
  row('', 'median', 'undisturbed');
  const both = (values) => [quantile(values, 0.5), quantile(values, 0.9)];
  row('ours, without silences: decoded, checked and logged', ...both(rates.ours).map(number));
  row('modbus-webserial 0.10.1', ...both(rates.peer).map(number));
  row('libmodbus, a program in C on the same cable', ...both(rates.libmodbus).map(number));
  const [ratio, undisturbed] = both(rates.ours).map((rate, index) => rate / both(rates.peer)[index]);
  const verdict = ratio >= TARGETS.peer ? 'met' : 'NOT MET';
  console.log(
    `  ${ratio.toFixed(2)} × modbus-webserial (undisturbed ${undisturbed.toFixed(2)}), target ${TARGETS.peer}: ${verdict}`,
  );
});

for (const baud of [9600, 115_200]) {
  test(`at ${baud} baud`, async ({ page, plugAdapter }) => {
    await plugAdapter({ pace: true });
    await choose(page);
    const times = await measure(page, 'ours', { baud, seconds: PACED_SECONDS });
    const least = await measure(page, 'least', { baud });
    const each = times.slice(1).map((time, index) => time - times[index]);
    const mean = (times.at(-1) - times[0]) / each.length;
    const median = quantile(each, 0.5);
    console.log(`\nThe same over a cable that takes the time of ${baud} baud, 8E1, silences kept; milliseconds each`);
    row('', 'median', 'mean');
    row('ours', number(median), number(mean));
    row('characters and silences', number(least), number(least));
    const share = (100 * least) / median;
    const verdict = share >= TARGETS.rules ? 'met' : 'NOT MET';
    const ofMean = ((100 * least) / mean).toFixed(0);
    console.log(
      `  ${share.toFixed(0)} % of what the rules allow (mean ${ofMean} %), target ${TARGETS.rules} %: ${verdict}`,
    );
  });
}
