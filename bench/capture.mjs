// `npm run bench:capture`: how fast a capture of a million Modbus packets, and a log of a million lines, are read and traced; the capture in
// turns with tshark on the same file.
// `npm run bench:capture -- FOLDER`: what is counted in the captures of a folder, beside what tshark counts in them.
import { execFile } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { performance } from 'node:perf_hooks';
import { promisify } from 'node:util';
import { runScript } from '../scripts/run.mjs';
import { asPcapng, millionLines, millionPackets } from './million-packets.mjs';
import { quantile } from './quantile.mjs';

const run = promisify(execFile);
const TURNS = 5;
const TARGET = 500_000;
const TRACED = 5000;
const TEXT = 10_000;
const MEMORY = 3;
const TIMES_TSHARK = 4.5;
const MEGABYTE = 1e6;

if ((await runScript('build:lib')) !== 0) process.exit(1);
const { crc16, readCapture, traceOf } = await import('../dist/lib/framewright.js');

const hasTshark = await run('tshark', ['--version']).then(
  () => true,
  () => false,
);
if (!hasTshark) console.log('tshark is not installed (Debian: apt-get install tshark): nothing is compared with it.\n');

/** Every function code and exception that tshark finds, but in segments that are sent again. */
async function tshark(file) {
  const { stdout } = await run(
    'tshark',
    [
      ...['-r', file, '-Y', 'modbus && !tcp.analysis.retransmission', '-T', 'fields', '-E', 'occurrence=a'],
      ...['-e', 'modbus.func_code', '-e', 'modbus.exception_code'],
    ],
    { maxBuffer: 1 << 30 },
  );
  const cells = stdout.split('\n').map((line) => line.split('\t'));
  const list = (column) => cells.flatMap((line) => (line[column] ?? '').split(',').filter(Boolean));
  return { codes: list(0).map(Number), exceptions: list(1).length };
}

function ours(records) {
  const codes = Array.from(records, ({ bytes, transport }) => bytes[transport === 'tcp' ? 7 : 1] ?? 0);
  return { codes: codes.map((code) => code & 0x7f), exceptions: codes.filter((code) => code > 0x7f).length };
}

function byFunction(codes) {
  const counts = new Map();
  for (const code of codes) counts.set(code, (counts.get(code) ?? 0) + 1);
  const sorted = [...counts].sort(([one], [other]) => one - other);
  return sorted.length > 8
    ? `${sorted.length} functions`
    : sorted.map(([code, count]) => `${code}: ${count}`).join(', ');
}

const [folder] = process.argv.slice(2);
if (folder !== undefined) await countFolder(folder);
else await timeMillion();

async function countFolder(path) {
  const files = readdirSync(path, { recursive: true, encoding: 'utf8' }).filter((file) =>
    /\.(?:pcap|pcapng|cap)$/.test(file),
  );
  for (const file of files.sort()) {
    const { format, records, problems } = readCapture(new Uint8Array(readFileSync(join(path, file))));
    const { faults, units, exchanges } = traceOf(records).summary();
    const own = ours(records);
    console.log(`${file} (${format})`);
    const print = (who, { codes, exceptions }) =>
      console.log(
        `  ${who.padEnd(11)} ${String(codes.length).padStart(7)} frames, ${exceptions} exceptions; ${byFunction(codes)}`,
      );
    print('framewright', own);
    if (hasTshark) print('tshark', await tshark(join(path, file)));
    const kinds = Object.entries(faults).flatMap(([kind, count]) => (count > 0 ? [`${kind} ${count}`] : []));
    console.log(`  ${exchanges} exchanges, units ${units.join(' ')}; ${kinds.join(', ') || 'no fault'}`);
    const codes = byCode(problems);
    if (codes !== '') console.log(`  not read: ${codes}`);
  }
}

function byCode(problems) {
  const counts = new Map();
  for (const { code } of problems) counts.set(code, (counts.get(code) ?? 0) + 1);
  return [...counts].map(([code, count]) => `${code} ${count}`).join(', ');
}

/** Milliseconds until the records are there, and until their summary is. */
function timed(bytes) {
  const start = performance.now();
  const { records } = readCapture(bytes);
  const middle = performance.now();
  const { frames } = traceOf(records).summary();
  if (frames !== 1_000_000) throw new Error(`${frames} frames`);
  return [middle - start, performance.now() - start];
}

/**
 * Bytes that a process of its own needs for a file: the most that were resident beyond what Node is before, with all that nobody has collected
 * yet; and those that are held once all is collected, the file among them.
 */
async function memoryFor(file) {
  const program = `
    import { readFileSync } from 'node:fs';
    import { readCapture, traceOf } from ${JSON.stringify(new URL('../dist/lib/framewright.js', import.meta.url).href)};
    const held = () => {
      globalThis.gc();
      const { heapUsed, arrayBuffers } = process.memoryUsage();
      return heapUsed + arrayBuffers;
    };
    const before = held();
    const resident = process.memoryUsage().rss;
    const trace = traceOf(readCapture(readFileSync(${JSON.stringify(file)})).records);
    trace.summary();
    // On Linux what getrusage says begins with the memory of the process that started this one.
    const most =
      (process.platform === 'linux'
        ? 1024 * /VmHWM:\\s+(\\d+)/.exec(readFileSync('/proc/self/status', 'latin1'))[1]
        : 1024 * process.resourceUsage().maxRSS) - resident;
    console.log(most, held() - before, trace.size);`;
  const { stdout } = await run(process.execPath, ['--expose-gc', '--input-type=module', '--eval', program]);
  const [most, kept] = stdout.split(' ').map(Number);
  return { most, kept };
}

async function timeMillion() {
  const place = mkdtempSync(join(tmpdir(), 'framewright-capture-'));
  const pcap = millionPackets();
  const files = [
    { name: 'pcap', bytes: pcap },
    { name: 'pcapng', bytes: asPcapng(pcap) },
    { name: 'log', bytes: millionLines(crc16) },
  ].map((file) => ({ ...file, path: join(place, `million.${file.name}`), read: [], traced: [] }));
  for (const { path, bytes } of files) writeFileSync(path, bytes);
  console.log(`1,000,000 packets with Modbus on 20 connections, and 1,000,000 lines; ${TURNS} turns.\n`);
  const theirs = [];
  for (let turn = 0; turn < TURNS; turn++) {
    for (const { bytes, read, traced } of files) {
      const [middle, end] = timed(bytes);
      read.push(middle);
      traced.push(end);
    }
    if (!hasTshark || turn >= 2) continue;
    const before = performance.now();
    const { codes } = await tshark(files[0].path);
    theirs.push(performance.now() - before);
    if (codes.length !== 1_000_000) throw new Error(`tshark: ${codes.length} frames`);
  }
  const rate = (times) => 1e9 / quantile(times, 0.5);
  const row = (name, times, note) =>
    console.log(
      `${name.padEnd(30)} ${(quantile(times, 0.5) / 1000).toFixed(2).padStart(6)} s ${Math.round(rate(times)).toLocaleString('en').padStart(12)} a second  ${note}`,
    );
  for (const { name, bytes, path, read, traced } of files) {
    const least = name === 'log' ? 0 : TARGET;
    const most = name === 'log' ? TEXT : TRACED;
    row(`${name}, put together`, read, rate(read) >= least ? '' : `below ${least}`);
    row(`${name}, trace and summary`, traced, quantile(traced, 0.5) <= most ? '' : `above ${most / 1000} s`);
    const { most: peak, kept } = await memoryFor(path);
    const times = (memory) => `${(memory / MEGABYTE).toFixed(0)} MB, ${(memory / bytes.length).toFixed(2)} times`;
    const tooMuch = name !== 'log' && peak / bytes.length > MEMORY ? `, above ${MEMORY}` : '';
    console.log(
      `  memory for ${(bytes.length / MEGABYTE).toFixed(0)} MB, the file among it: at most ${times(peak)} as long, with what is not collected yet${tooMuch};`,
    );
    console.log(`  held in the end, all collected: ${times(kept)}`);
  }
  if (theirs.length > 0) {
    const times = rate(files[0].read) / rate(theirs);
    const note = times >= TIMES_TSHARK ? '' : `, below ${TIMES_TSHARK}`;
    row('tshark, the pcap', theirs, `we read ${times.toFixed(1)} times as fast${note}`);
    console.log(`  with trace and summary we are ${(rate(files[0].traced) / rate(theirs)).toFixed(1)} times as fast`);
  }
  rmSync(place, { recursive: true });
}
