import { expect, test } from 'vitest';
import { type ProgramOptions, writeProgram } from '../../src/codegen/index.ts';
import { builtInProfiles } from '../../src/devices/index.ts';
import { encodeFrame, type FrameInput, spacedHex, toHex } from '../../src/modbus/index.ts';
import type { Sequence } from '../../src/sequences/index.ts';
import { nastyProfile } from './c/programs.ts';
import { type CaseReply, PATIENT, type ProgramCase, programCases, repliesTo, sequences } from './cases.ts';
import { namedPrograms } from './hostile.ts';
import { type Answer, loopback, openLines, openServer, SERVER_PORTS, SLAVE_PORT } from './line.ts';
import { expectServed, slaveCases, startSlave, toNobody } from './peers/slave.ts';
import { expectProved, type Ran, withTools } from './tools.ts';

/** A program that is compiled: its file, and what it was written for. */
export interface Written {
  /** What it is called in the test: a letter, then letters and digits. */
  readonly id: string;
  readonly file: { readonly name: string; readonly text: string };
  readonly cases: readonly ProgramCase[];
  readonly checks: boolean;
}

/**
 * Runs programs that were compiled into one: each line of the input is the `id` of one and its own arguments, apart by tabs. Behind
 * what each of them writes comes U+0003, its exit code and U+0004.
 */
export type Runner = (input: string) => Promise<Ran>;

const hex = (bytes: Uint8Array): string => spacedHex(toHex(bytes));

/** Names and notes that could break out of where they stand, or are taken. */
const NASTY = [
  '*/ /* // "quoted" \\',
  '</summary> --> ]]> &amp; `backtick`',
  '\\u0022 \\uzzzz {0} {} %d %n $x',
  'line\nend \u2028 \u202e back',
  'Überdruck Öffnen',
  '3 phases',
  'class',
  'main',
  'reply',
  'type',
  'crc',
  'loop',
  'Len',
];

const read = (startAddress: number, quantity: number): FrameInput => ({
  transport: 'rtu',
  direction: 'request',
  unitId: 17,
  functionCode: 3,
  fields: { startAddress, quantity },
});

const sequenceOf = (last: number, timeout: number): Sequence => {
  const write = (value: number) => encodeFrame({ ...read(0, 1), functionCode: 6, fields: { address: 1, value } });
  const until = { kind: 'until', unit: 17, table: 'holding-register', address: 8, type: 'u16', order: 'ABCD' } as const;
  return {
    transport: 'rtu',
    steps: [
      { kind: 'send', bytes: write(1), onFailure: 'stop' },
      {
        kind: 'repeat',
        times: 2,
        steps: [
          { kind: 'send', bytes: write(2), onFailure: 'go-on' },
          { kind: 'wait', duration: 15 },
        ],
      },
      { ...until, relation: '≥', value: last, interval: 20, timeout, onFailure: 'stop' },
      { kind: 'send', bytes: write(3), onFailure: 'stop' },
    ],
    finally: [
      { kind: 'send', bytes: write(4), onFailure: 'stop' },
      { kind: 'send', bytes: write(5), onFailure: 'stop' },
    ],
  };
};

const drive = builtInProfiles.find(({ id }) => id === 'weg-drive');

/** Time-outs in milliseconds, of programs that get half a reply, and of those that get none. */
const MIDDLE = 3000;
const SHORT = 150;

/** All programs of a target: every function, random requests, all options at least once, and sequences. */
export function programsOf(target: string): readonly Written[] {
  const written: Written[] = [];
  const add = (
    id: string,
    what: Parameters<typeof writeProgram>[1],
    cases: readonly ProgramCase[],
    options: ProgramOptions = {},
  ) => {
    const [file] = writeProgram(target, what, { timeout: PATIENT, ...options }).files;
    if (file === undefined) throw new Error(`${id}: no file`);
    const checks = options.part !== 'bytes' && options.part !== 'build';
    written.push({ id, file, cases, checks });
  };
  const frames = (id: string, cases: readonly ProgramCase[], options: ProgramOptions = {}) =>
    add(id, { frames: cases }, cases, options);
  const single = (id: string, request: FrameInput, options: ProgramOptions = {}) =>
    add(id, { request }, [{ name: id, request }], options);

  const rtu = programCases('rtu');
  const some = rtu.slice(0, 8);
  frames('rtu', rtu);
  frames('ascii', programCases('ascii'));
  frames('tcp', programCases('tcp'));
  frames('table', some, { crc: 'table', part: 'check', comments: false });
  frames('tables', some, { crc: 'two-tables', echo: true, comments: false });
  frames('build', some, { part: 'build' });
  frames('bytes', some, { part: 'bytes' });
  frames(
    'nasty',
    NASTY.map((name, index) => ({ name, request: read(index, 1) })),
    {
      names: { buildReply: 'class', quantity: 'while', startAddress: '1st', start_address: 'Größe "x"', crc: 'main' },
    },
  );
  for (const [index, request] of [read(8, 2), { ...read(8, 2), transport: 'ascii' as const }].entries())
    for (const part of ['bytes', 'build', 'check', 'exchange'] as const)
      single(`part${index}${part}`, request, { part, comments: part === 'check', name: `part ${index} ${part}` });
  single('broadcast', { ...read(0, 1), unitId: 0, functionCode: 6, fields: { address: 1, value: 3 } });
  single('good', read(8, 2));
  single('silent', read(8, 2), { timeout: SHORT });
  single('half', read(8, 2), { timeout: MIDDLE });
  single('echo', read(8, 2), { echo: true, line: { baud: 115_200, parity: 'none', stopBits: 2 } });
  single('open', { ...read(8, 2), functionCode: 0x11, fields: {} }, { line: { baud: 9600, parity: 'odd' } });
  single('ascii1', { ...read(8, 2), transport: 'ascii' }, { line: { dataBits: 7 } });
  for (const [index, { request, options }] of namedPrograms.entries())
    single(`names${index}`, request, { part: 'check', ...options });
  for (const [index, sequence] of sequences.entries()) add(`builtin${index}`, { sequence }, []);
  add('sequence', { sequence: sequenceOf(3, PATIENT) }, []);
  add('stopped', { sequence: sequenceOf(60_000, SHORT) }, []);
  const units = { profile: drive, units: true };
  const write = (functionCode: number, fields: FrameInput['fields']) => ({ ...read(0, 1), functionCode, fields });
  add('units', { request: read(681, 2) }, [], units);
  single('inunits', write(0x06, { address: 683, value: 4096 }), units);
  single('manyinunits', write(0x10, { startAddress: 682, registers: [1, 4096] }), units);
  single('kinds', read(0, 60), { profile: nastyProfile, units: true });
  const tcp = { ...read(8, 2), transport: 'tcp', transactionId: 7 } as const;
  for (const [index, port] of SERVER_PORTS.entries())
    single(`tcp${index + 1}`, tcp, { timeout: index === 0 ? PATIENT : SHORT, server: { host: 'localhost', port } });
  for (const transport of ['rtu', 'tcp'] as const) {
    // A pseudo-terminal has no parity, and Mono takes it amiss when asked a second time.
    const options = { line: { parity: 'none' }, server: { port: SLAVE_PORT } } as const;
    frames(`slave${transport}`, slaveCases(transport), options);
    single(`nobody${transport}`, toNobody(transport), { ...options, timeout: SHORT });
  }
  return written;
}

interface Called {
  readonly text: string;
  readonly code: number;
}

/** Calls programs one after another. */
async function called(runner: Runner, calls: readonly (readonly string[])[]): Promise<readonly Called[]> {
  const { out, err } = await runner(calls.map((call) => `${call.join('\t')}\n`).join(''));
  const found = out.split('\u0004').slice(0, -1);
  if (found.length !== calls.length) throw new Error(`${found.length} of ${calls.length} programs ran:\n${err}`);
  return found.map((text) => {
    const [said = '', code] = text.split('\u0003');
    return { text: said.trim(), code: Number(code) };
  });
}

/** What `--check` says of each request: the verdict's number, and the list behind it. */
function verdicts(text: string): readonly { readonly result: number; readonly list: readonly number[] }[] {
  const found: { result: number; list: readonly number[] }[] = [];
  for (const line of text.split('\n')) {
    const verdict = /: (?:(good)|exception (\d+): .*|fault (-\d+): .*)\s*$/.exec(line);
    if (verdict) found.push({ result: Number(verdict[2] ?? verdict[3] ?? 0), list: [] });
    const last = found.at(-1);
    if (verdict || last === undefined) continue;
    const items = line.match(/-?\d+|true|false/gi) ?? [];
    last.list = items.map((item) => (/true/i.test(item) ? 1 : /false/i.test(item) ? 0 : Number(item)));
  }
  return found;
}

/**
 * Says the tests of programs that run in one process. `runner` gives what runs them, when they are compiled by the command
 * that is said to compile them.
 */
export function testPrograms(
  written: readonly Written[],
  runner: () => Promise<Runner>,
  { target, command }: { readonly target: string; readonly command: string },
): void {
  test('programs are said to have been compiled and run as they were', () => {
    const tried = written.filter(({ id }) => ['rtu', 'ascii', 'tcp'].includes(id));
    expectProved(target, { how: 'compiled', command, frames: tried.reduce((sum, { cases }) => sum + cases.length, 0) });
  });

  test('every program sends the bytes that the frame has', async () => {
    const asked = written.filter(({ cases }) => cases.length > 0);
    const got = await called(
      await runner(),
      asked.map(({ id }) => [id, '--bytes']),
    );
    expect(asked.map(({ id }, at) => [id, got[at]?.code, got[at]?.text.split(/\r?\n/)])).toEqual(
      asked.map(({ id, cases }) => [id, 0, cases.map(({ request }) => hex(encodeFrame(request)))]),
    );
  });

  testUnits(runner);

  test('every check of a reply finds what is wrong, and takes the values out', async () => {
    const rounds = written
      .filter(({ checks, cases }) => checks && cases.length > 0)
      .flatMap(({ id, cases }) => {
        const replies = cases.map(({ request }) => repliesTo(request)).filter((list) => list.length > 0);
        const most = Math.max(0, ...replies.map((list) => list.length));
        return Array.from({ length: most }, (_, round) => ({
          id,
          replies: replies.map((list) => list[round % list.length] as CaseReply),
        }));
      });
    const got = await called(
      await runner(),
      rounds.map(({ id, replies }) => [id, '--check', ...replies.map(({ bytes }) => hex(bytes))]),
    );
    for (const [at, { id, replies }] of rounds.entries()) {
      const found = verdicts(got[at]?.text ?? '');
      const isFault = replies.some(({ result }) => result !== 0);
      expect({ id, found: found.length, code: got[at]?.code }).toEqual({
        id,
        found: replies.length,
        code: isFault ? 1 : 0,
      });
      const actual = replies.map(({ what, result, list }, index) => {
        const own = found[index] ?? { result: Number.NaN, list: [] };
        return {
          what,
          result: result === 'fault' && own.result < 0 ? result : own.result,
          list: own.list.slice(0, list?.length ?? 0),
        };
      });
      expect({ id, actual }).toEqual({
        id,
        actual: replies.map(({ what, result, list = [] }) => ({ what, result, list })),
      });
    }
  });
}

/** Says the test of a program that gives values of a device in its units. */
function testUnits(runner: () => Promise<Runner>): void {
  test('values of a device are given in units', async () => {
    const reply = encodeFrame({ ...read(681, 2), direction: 'response', fields: { registers: [4000, 3] } });
    const [ran] = await called(await runner(), [['units', '--check', hex(reply)]]);
    expect(ran).toMatchObject({ code: 0 });
    expect(ran?.text).toMatch(/p0681 actual speed = 29\.296875 Hz\s+p0682 control word = 3\s/);
  });
}

/** A reply in two pieces. */
const pieces = (bytes: Uint8Array): readonly Uint8Array[] => [bytes.subarray(0, 2), bytes.subarray(2)];

/** What is carried out on a line: the program, what the device does, and what comes of it. */
interface Exchange {
  readonly what: string;
  readonly id: string;
  readonly answer: Answer;
  readonly code: number;
  /** In what the program says. */
  readonly says: RegExp;
  /** What the device has heard; the program's own frame by default. */
  readonly heard?: readonly string[];
}

/** The registers that a device of the sequences answers. */
const deviceOf = (refuses: (value: number) => boolean): Answer => {
  let asked = 0;
  return (request) => {
    const reply = { transport: 'rtu', direction: 'response', unitId: 17, functionCode: request[1] } as const;
    if (request[1] === 3) return [encodeFrame({ ...reply, fields: { registers: [++asked] } })];
    if (refuses(request[5] ?? 0)) return [encodeFrame({ ...reply, functionCode: 0x86, fields: { exceptionCode: 4 } })];
    return pieces(request);
  };
};

const frame = (value: number): string =>
  hex(encodeFrame({ ...read(0, 1), functionCode: 6, fields: { address: 1, value } }));
const asks = hex(encodeFrame(read(8, 1)));

/** Says the tests of exchanges on pseudo-terminals, and with servers on loopback; `runner` as it is for `testPrograms`. */
export function testExchanges(written: readonly Written[], runner: () => Promise<Runner>): void {
  const requestOf = (id: string): FrameInput => {
    const request = written.find((one) => one.id === id)?.cases[0]?.request;
    if (request === undefined) throw new Error(`no program ${id}`);
    return request;
  };
  const good = (id: string): Uint8Array => (repliesTo(requestOf(id))[0] as CaseReply).bytes;
  const exchanges: readonly Exchange[] = [
    { what: 'a good reply', id: 'good', answer: () => pieces(good('good')), code: 0, says: /: good\s+\D*4660\D+8515/ },
    { what: 'no reply', id: 'silent', answer: () => [], code: 1, says: /fault -8: no reply/ },
    {
      what: 'half a reply',
      id: 'half',
      answer: () => pieces(good('half')).slice(0, 1),
      code: 1,
      says: /fault -1: /,
    },
    {
      what: 'an exception',
      id: 'good',
      answer: () => [(repliesTo(requestOf('good'))[1] as CaseReply).bytes],
      code: 1,
      says: /exception 2: ILLEGAL DATA ADDRESS/,
    },
    {
      what: 'an adapter that gives back what is sent',
      id: 'echo',
      answer: (request) => [request, ...pieces(good('echo'))],
      code: 0,
      says: /: good/,
    },
    { what: 'a reply that silence ends', id: 'open', answer: () => [good('open')], code: 0, says: /: good/ },
    { what: 'ASCII', id: 'ascii1', answer: () => pieces(good('ascii1')), code: 0, says: /: good/ },
    { what: 'a broadcast', id: 'broadcast', answer: () => [], code: 0, says: /: $/ },
    {
      what: 'a sequence',
      id: 'sequence',
      answer: deviceOf((value) => value === 2),
      code: 0,
      says: /exception 4: /,
      heard: [frame(1), frame(2), frame(2), asks, frame(3), frame(4), frame(5)],
    },
    {
      what: 'a sequence whose condition does not come in time',
      id: 'stopped',
      answer: deviceOf(() => false),
      code: 1,
      says: /: good/,
      heard: [frame(1), frame(2), frame(2), asks, frame(4), frame(5)],
    },
    {
      what: 'a sequence that is stopped',
      id: 'sequence',
      answer: deviceOf((value) => value === 1 || value === 4),
      code: 1,
      says: /exception 4: /,
      heard: [frame(1), frame(4), frame(5)],
    },
  ];

  test('exchanges on a serial line', async () => {
    const { lines, close } = await openLines(exchanges.map(({ answer }) => answer));
    const ran = await called(
      await runner(),
      exchanges.map(({ id }, at) => [id, lines[at]?.path ?? '']),
    );
    for (const [at, { what, id, code, says, heard }] of exchanges.entries()) {
      const expected = heard ?? [hex(encodeFrame(requestOf(id)))];
      const line = lines[at];
      await line?.hears(expected.length);
      // How often it is asked in the time that there is, nobody can say.
      const got = line?.heard.map(hex).filter((one, index, all) => one !== asks || one !== all[index - 1]);
      expect({ what, code: ran[at]?.code, heard: got }).toEqual({ what, code, heard: expected });
      expect(`${what}: ${ran[at]?.text}`).toMatch(says);
    }
    close();
  });

  test('exchanges with a server', async () => {
    const host = loopback();
    const answers: readonly Answer[] = [() => pieces(good('tcp1')), () => []];
    const servers = await Promise.all(answers.map((answer, at) => openServer(answer, host, SERVER_PORTS[at])));
    const ran = await called(
      await runner(),
      ['tcp1', 'tcp2'].map((id) => [id, host]),
    );
    for (const server of servers) server.close();
    expect(ran.map(({ code }) => code)).toEqual([0, 1]);
    expect(ran[0]?.text).toMatch(/: good/);
    expect(ran[1]?.text).toMatch(/fault -8: no reply/);
  });

  withTools(['libmodbus'], () => {
    test('libmodbus answers what it is asked, on a serial line and as a server', async () => {
      const slave = await startSlave();
      const ran = await called(await runner(), [
        ['slavertu', slave.serial],
        ['nobodyrtu', slave.serial],
        ['slavetcp', slave.host],
        ['nobodytcp', slave.host],
      ]);
      slave.end();
      for (const at of [0, 2]) expectServed(ran[at]?.text ?? '');
      for (const at of [1, 3])
        expect(ran[at]).toMatchObject({ code: 1, text: expect.stringMatching(/fault -8: no reply/) });
    });
  });
}
