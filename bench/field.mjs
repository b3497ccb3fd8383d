// `npm run bench:field`: of the texts that people have posted, and of damaged conversations written in every dialect of log
// that is known, how many are read right, have the right finding first, and have their replies paired with their requests.
import { readFileSync } from 'node:fs';
import { runScript } from '../scripts/run.mjs';
import { Random } from './random.mjs';

const CASES = Number(process.env.CASES ?? 4);
const TARGET = 97;

if (process.env.BUILT === undefined && (await runScript('build:lib')) !== 0) process.exit(1);
const { diagnose, readBytes, readConversation, toHex } = await import('../dist/lib/framewright.js');
const { conversation, frames } = await import('./diagnose/conversations.mjs');
const { caseOf, ways } = await import('./diagnose/ways.mjs');
const { writeLog } = await import('./field/write-log.mjs');

const vectors = (name) => JSON.parse(readFileSync(new URL(`../tests/vectors/${name}.json`, import.meta.url), 'utf8'));
const logs = vectors('field-logs');
const userFrames = vectors('user-frames');
const dialects = vectors('dialects').filter(({ heldOut }) => process.env.SEEN === undefined || !heldOut);
const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.some((part) => name.includes(part));
const show = process.env.SHOW !== undefined;

const spaced = (bytes) => toHex(bytes).replace(/..(?=.)/g, '$& ');
const written = ({ side, bytes }) => `${side}: ${spaced(bytes)}`;
const share = ({ right, all }) => (all === 0 ? '–' : `${((100 * right) / all).toFixed(1)} %`);
const count = () => ({ right: 0, all: 0 });
const add = (counted, isRight) => {
  counted.all++;
  if (isRight) counted.right++;
};

function chunksOf({ bytes, chunks }) {
  return chunks.map(({ from, to, direction = '-' }) => ({ side: direction, bytes: bytes.slice(from, to) }));
}

/** What is sent in a log is a request, as the page takes it too. */
const hinted = ({ direction, ...chunk }) => ({
  ...chunk,
  direction: { tx: 'request', rx: 'response' }[direction] ?? direction,
});

/** A side of `-` in the dialect says that the text leaves it open. */
const isSame = (one, expected) => {
  if (one.length !== expected.length) return false;
  return one.every(({ side, bytes }, i) => {
    const other = expected[i];
    return (other.side === '-' || other.side === side) && spaced(bytes) === spaced(other.bytes);
  });
};

function handedOver() {
  const read = count();
  const first = count();
  for (const { id, text, expect } of logs.filter(({ id }) => isWanted(id))) {
    const got = readBytes(text);
    const chunks = chunksOf(got).map(written);
    if (expect.chunks !== undefined) {
      const isRight = chunks.join('\n') === expect.chunks.join('\n');
      add(read, isRight);
      if (show && !isRight) console.log(id, { expected: expect.chunks, got: chunks });
    }
    if (expect.finding !== undefined) {
      const codes = new Set(expect.finding.match(/[a-z]+(?:-[a-z]+)+|valid|truncated|merged|noise|echo/g) ?? []);
      const found = got.chunks.flatMap(({ from, to }) => diagnose(got.bytes.subarray(from, to)).slice(0, 1));
      add(
        first,
        // Where no finding is named, none may be surer than possible.
        codes.size === 0 ? found.at(-1)?.confidence === 'possible' : found.some(({ code }) => codes.has(code)),
      );
    }
  }
  const frame = count();
  const finding = count();
  for (const { pasted, pastedIsProse, hex, finding: code, transport, answering } of userFrames) {
    const got = readBytes(pasted).bytes;
    if (pastedIsProse !== true) add(frame, spaced(got) === hex);
    const bytesOf = (text) => Uint8Array.from(text.split(' '), (pair) => Number.parseInt(pair, 16));
    const request = answering && /^[\dA-F ]+$/i.test(answering) ? bytesOf(answering) : undefined;
    if (hex && code) add(finding, diagnose(bytesOf(hex), { transport, request })[0]?.code === code);
  }
  console.log(
    `field vectors   read right ${share(read)} of ${read.all}   first finding ${share(first)} of ${first.all}`,
  );
  console.log(
    `user frames     read right ${share(frame)} of ${frame.all}   first finding ${share(finding)} of ${finding.all}`,
  );
}

/** A conversation of three exchanges, one frame of the second damaged; `damaged` is its place. */
function damagedConversation(way, random) {
  for (;;) {
    const known = (random.next() & 1) === 1;
    const said = conversation(random);
    const damaged = caseOf(way, said, random, known);
    if (damaged === undefined || damaged.bytes.length < 2) continue;
    const transport = way.transport ?? 'rtu';
    const isReply = damaged.context.request !== undefined;
    const entries = [];
    for (let i = 0; i < 3; i++) {
      const pair = frames(i === 1 ? said : conversation(random), transport, random.next() & 0xffff);
      const request = i === 1 ? (isReply ? damaged.context.request : damaged.bytes) : pair.request;
      const reply = i === 1 && isReply ? damaged.bytes : pair.reply;
      entries.push({ side: 'tx', bytes: request }, { side: 'rx', bytes: reply });
    }
    return { entries, context: damaged.context, damaged: isReply ? 3 : 2 };
  }
}

function inDialect(dialect) {
  const random = new Random();
  const [read, finding, pairs] = [count(), count(), count()];
  for (const way of ways) {
    for (let n = 0; n < CASES; n++) {
      const { entries, context, damaged } = damagedConversation(way, random);
      const { text, chunks } = writeLog(dialect, entries);
      const got = readBytes(text);
      const isRight = isSame(chunksOf(got), chunks);
      add(read, isRight);
      if (show && !isRight) {
        console.log(`--- ${dialect.name}, ${way.name}, as ${got.reading}\n${text}`);
        const [one, other] = [chunksOf(got).map(written), chunks.map(written)];
        const at = other.findIndex((line, i) => line !== one[i] && line !== `-${one[i]?.slice(one[i].indexOf(':'))}`);
        console.log(
          `chunk ${at} of ${one.length}, expected ${other.length}\nexpected ${other[at]}\ngot      ${one[at]}`,
        );
      }
      if (isRight) {
        const { from, to } = got.chunks[damaged];
        const [first] = diagnose(got.bytes.subarray(from, to), context);
        add(finding, [way.finding].flat().includes(first?.code));
      }
      const answered = readConversation(got.bytes, got.chunks.map(hinted)).flatMap((item) => item.answers ?? []);
      // The exchanges before and after the damaged one are whole.
      add(pairs, isRight && answered.includes(0));
    }
  }
  return { read, finding, pairs };
}

const totals = { known: [count(), count(), count()], 'held out': [count(), count(), count()] };
function generated() {
  console.log(`\n${'dialect'.padEnd(34)}  read right  first finding  pairs`);
  for (const dialect of dialects.filter(({ name }) => isWanted(name))) {
    const { read, finding, pairs } = inDialect(dialect);
    const kind = dialect.heldOut ? 'held out' : 'known';
    for (const [i, counted] of [read, finding, pairs].entries()) {
      totals[kind][i].right += counted.right;
      totals[kind][i].all += counted.all;
    }
    const name = `${dialect.name}${dialect.heldOut ? ' (held out)' : ''}`;
    console.log(
      `${name.padEnd(34)} ${share(read).padStart(11)} ${share(finding).padStart(14)} ${share(pairs).padStart(8)}`,
    );
  }
  for (const [kind, [read, finding, pairs]] of Object.entries(totals)) {
    if (read.all === 0) continue;
    const mark = (100 * read.right) / read.all < TARGET ? `  below ${TARGET} %` : '';
    console.log(
      `${`all ${kind}`.padEnd(34)} ${share(read).padStart(11)} ${share(finding).padStart(14)} ${share(pairs).padStart(8)}${mark}`,
    );
  }
}

handedOver();
generated();
