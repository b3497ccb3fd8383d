import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { crcWays, type ProgramOptions, programParts } from '../../src/codegen/options.ts';
import { type ProgramSubject, writeFor } from '../../src/codegen/program.ts';
import type { Target } from '../../src/codegen/target.ts';
import { builtInProfiles } from '../../src/devices/index.ts';
import { encodeFrame, type FrameInput, toHex } from '../../src/modbus/index.ts';
import type { Sequence } from '../../src/sequences/index.ts';
import { PATIENT, type ProgramCase, programCases, repliesTo, sequences } from './cases.ts';
import { namedPrograms } from './hostile.ts';
import { PEER_PORT, SLAVE_PORT } from './line.ts';
import { Peer, Runner } from './peers/peers.ts';
import { expectServed, slaveCases, startSlave, toNobody } from './peers/slave.ts';
import { emptyFolder, expectProved, withTools } from './tools.ts';

/** What the programs of a language without a compiler are called, and how they print bytes. */
export interface Scripts {
  readonly target: Target;
  readonly language: 'python' | 'javascript';
  readonly ending: string;
  readonly bytes: (hex: string) => string;
  /** The command that is said to check them. */
  readonly command: string;
}

/** Names that a user may think of, and that no program may take as they are. */
const NAMES = [
  'class',
  '3 phase motor',
  'Größe',
  'say "hello"',
  '*/ end',
  '"""',
  '\\',
  'line\nend',
  'exchange',
  'crc',
  '',
  '名',
];

/** The programs of one language. */
export class ScriptFolder {
  readonly folder: string;
  readonly #scripts: Scripts;
  readonly #names = new Set<string>();

  constructor(scripts: Scripts) {
    this.#scripts = scripts;
    this.folder = emptyFolder(scripts.target.id);
  }

  write(name: string, what: ProgramSubject, options: ProgramOptions = {}): string {
    const [file] = writeFor(this.#scripts.target, what, options).files;
    const called = `${name.replaceAll(' ', '_')}${this.#scripts.ending}`;
    if (this.#names.has(called)) throw new Error(`two programs ${called}`);
    this.#names.add(called);
    const path = join(this.folder, called);
    writeFileSync(path, file?.text ?? '');
    return path;
  }
}

const request = (functionCode: number, fields: FrameInput['fields'], transport: FrameInput['transport'] = 'rtu') =>
  ({ transport, direction: 'request', unitId: 6, functionCode, fields }) as const;
/** A time-out in milliseconds, for replies that do not come. */
const SHORT = 100;

const POLLED = { timeout: PATIENT };

/** A pseudo-terminal has no parity. */
const line = { parity: 'none' } as const;
const read = (quantity: number, transport?: FrameInput['transport']) =>
  request(0x03, { startAddress: 681, quantity }, transport);
const reply = (asked: FrameInput, fields: FrameInput['fields']) =>
  encodeFrame({ ...asked, direction: 'response', fields });

/** Tests of programs that need no compiler: what `check` proves of all files at once, bytes, replies, names and exchanges. */
export function testScripts(scripts: Scripts, check: (folder: string) => Promise<void>): void {
  const folder = new ScriptFolder(scripts);
  const { bytes, target } = scripts;
  const cases = (['rtu', 'ascii', 'tcp'] as const).flatMap((transport) =>
    programCases(transport).map((one, index): ProgramCase & { readonly file: string } => {
      const crc = crcWays[index % crcWays.length];
      const options = { crc, comments: index % 5 !== 4, echo: index % 7 === 6 };
      return { ...one, file: folder.write(`${transport} ${one.name}`, { request: one.request }, options) };
    }),
  );
  const parts = programParts.map((part) => ({
    part,
    file: folder.write(`part ${part}`, { request: read(2) }, { part, names: { address: 'class' } }),
  }));
  const bare = folder.write('bare', { request: request(0x06, { address: 1, value: 3 }, 'pdu') });
  const named = NAMES.map((name, index) =>
    folder.write(
      `named ${index}`,
      { request: read(1) },
      { name, names: { quantity: name, startAddress: name, start_address: name } },
    ),
  );
  const replaced = namedPrograms.map(({ request, options }, index) => ({
    request,
    file: folder.write(`replaced ${index}`, { request }, options),
  }));
  const several = folder.write('several', {
    frames: NAMES.map((name, index) => ({ name, request: request(0x06, { address: index, value: 1 }) })),
  });
  const shipped = sequences.map((sequence, index) => folder.write(`sequence ${index}`, { sequence }));
  const [drive] = builtInProfiles.filter(({ id }) => id.includes('weg'));
  const units = { profile: drive, units: true };
  const speed = folder.write('in units', { request: read(2) }, units);
  const reference = folder.write('written in units', { request: request(0x06, { address: 683, value: 4096 }) }, units);
  const references = folder.write(
    'many in units',
    { request: request(0x10, { startAddress: 682, registers: [1, 4096] }) },
    units,
  );
  let runner: Runner;
  let peer: Peer;
  beforeAll(async () => {
    runner = new Runner(scripts.language);
    peer = await Peer.start();
  });
  afterAll(() => {
    runner.end();
    peer.end();
  });

  describe(target.name, () => {
    test('writes programs that a strict checker accepts', async () => {
      expect(shipped.length).toBeGreaterThan(0);
      await check(folder.folder);
    });

    test('is said to have been checked and run as it is', () => {
      expectProved(target.id, { how: 'checked', command: scripts.command, frames: cases.length });
    });

    test('makes the bytes of every request', async () => {
      for (const { name, request: asked, file } of cases) {
        const { code, out } = await runner.main(file, '--bytes');
        expect([name, code, out]).toEqual([name, 0, `${bytes(toHex(encodeFrame(asked)))}\n`]);
      }
    });

    test('says of every reply what is wrong with it', async () => {
      for (const { name, request: asked, file } of cases) {
        for (const { what, bytes: got, result, list } of repliesTo(asked)) {
          const { code, out } = await runner.main(file, '--check', toHex(got));
          const [verdict = ''] = out.match(/(?<=: )(good|exception \d+|fault -\d+)/) ?? [];
          const told = `${name}, ${what}: ${code} ${verdict}`;
          if (result === 0) expect(told).toBe(`${name}, ${what}: 0 good`);
          else if (result === 'fault') expect(told).toMatch(/: 1 fault -\d+$/);
          else expect(told).toBe(`${name}, ${what}: 1 ${result > 0 ? 'exception' : 'fault'} ${result}`);
          if (list === undefined || what !== 'good') continue;
          const values = (/: (.*)\n$/.exec(out)?.[1] ?? '').split(' ').map((text) => Number(VALUES[text] ?? text));
          expect([name, values.slice(0, list.length)]).toEqual([name, [...list]]);
        }
      }
    });

    test('writes each part, and no names that the language does not take', async () => {
      for (const { file } of parts) expect((await runner.main(file, '--bytes')).code).toBe(0);
      expect((await runner.main(bare, '--bytes')).out).toBe(`${bytes('0600010003')}\n`);
      for (const file of named) {
        expect((await runner.main(file, '--bytes')).out).toBe(`${bytes(toHex(encodeFrame(read(1))))}\n`);
      }
      for (const { request, file } of replaced) {
        expect((await runner.main(file, '--bytes')).out).toBe(`${bytes(toHex(encodeFrame(request)))}\n`);
      }
      const { out } = await runner.main(several, '--bytes');
      expect(out.trim().split('\n')).toHaveLength(NAMES.length);
    });

    test('gives and takes values of a device in units', async () => {
      expect(drive).toBeDefined();
      // 4000 of 8192 for 60 Hz; the control word 3.
      const { code, out } = await runner.main(speed, '--check', toHex(reply(read(2), { registers: [4000, 3] })));
      expect(code).toBe(0);
      expect(out).toMatch(/p0681 actual speed = 29\.296875 Hz\np0682 control word = 3\n/);
      expect((await runner.main(reference, '--bytes')).out).toBe(`${bytes('060602AB1000F5E5')}\n`);
      const many = encodeFrame(request(0x10, { startAddress: 682, registers: [1, 4096] }));
      expect((await runner.main(references, '--bytes')).out).toBe(`${bytes(toHex(many))}\n`);
    });

    const exchanged = [
      ['rtu', false],
      ['rtu', true],
      ['ascii', false],
      ['tcp', false],
    ] as const;
    test.each(exchanged)('exchanges a request for its reply: %s, echo %s', async (transport, echo) => {
      const asked = read(2, transport);
      const sent = encodeFrame(asked);
      const options = { echo, line, server: { port: PEER_PORT } };
      const [patient, hasty] = [PATIENT, SHORT].map((timeout) =>
        folder.write(`exchange ${transport} ${echo} ${timeout}`, { request: asked }, { ...options, timeout }),
      );
      const given = [transport === 'tcp' ? peer.host : peer.port];
      const answers = [
        [reply(asked, { registers: [0x1234, 7] }), 0, /: good\nregisters: 4660 7\n$/],
        [
          encodeFrame({ ...asked, direction: 'response', functionCode: 0x83, fields: { exceptionCode: 2 } }),
          1,
          /exception 2: ILLEGAL/,
        ],
        [undefined, 1, /fault -8: no reply/],
        [reply(asked, { registers: [0x1234, 7] }), 0, /: good\nregisters: 4660 7\n$/],
      ] as const;
      for (const [answer, code, out] of answers) {
        await peer.expect(sent, answer, { echo });
        const ended = await runner.main((answer ? patient : hasty) ?? '', ...given);
        expect(ended.out).toMatch(out);
        expect(ended.code).toBe(code);
        expect(await peer.got(sent.length)).toBe(toHex(sent));
      }
    });

    withTools(['libmodbus'], () => {
      test.each(['rtu', 'tcp'] as const)('asks libmodbus by %s', async (transport) => {
        const slave = await startSlave();
        const options = { line, server: { port: SLAVE_PORT } };
        const asks = folder.write(
          `slave ${transport}`,
          { frames: slaveCases(transport) },
          { ...options, timeout: PATIENT },
        );
        const nobody = folder.write(
          `nobody ${transport}`,
          { request: toNobody(transport) },
          { ...options, timeout: SHORT },
        );
        const where = transport === 'tcp' ? slave.host : slave.serial;
        expectServed((await runner.main(asks, where)).out);
        expect(await runner.main(nobody, where)).toMatchObject({
          code: 1,
          out: expect.stringMatching(/fault -8: no reply/),
        });
        slave.end();
      });
    });

    test('waits for silence where no byte says how long the reply is', async () => {
      const asked = request(0x08, { subFunction: 0, data: 'A5370102' });
      const file = folder.write('silence', { request: asked }, { timeout: PATIENT, line });
      await peer.expect(encodeFrame(asked), reply(asked, { subFunction: 0, data: 'A5370102' }));
      expect(await runner.main(file, peer.port)).toMatchObject({ code: 0, out: expect.stringMatching(/good/) });
    });

    test('waits for no reply to a broadcast', async () => {
      const asked = { ...request(0x06, { address: 1, value: 3 }), unitId: 0 };
      const file = folder.write('broadcast', { request: asked }, { timeout: PATIENT, line });
      await peer.expect(encodeFrame(asked), undefined);
      expect((await runner.main(file, peer.port)).code).toBe(0);
      expect(await peer.got(8)).toBe(toHex(encodeFrame(asked)));
    });

    test('carries out a sequence, and what comes at last whatever became of it', async () => {
      const sequence = (times: number, timeout: number): Sequence => ({
        transport: 'rtu',
        steps: [
          { kind: 'repeat', times, steps: [{ kind: 'send', bytes: encodeFrame(read(1)), onFailure: 'stop' }] },
          { kind: 'wait', duration: 5 },
          {
            kind: 'until',
            unit: 6,
            table: 'holding-register',
            address: 681,
            type: 'u16',
            order: 'ABCD',
            relation: '≥',
            value: 40,
            interval: 10,
            timeout,
            onFailure: 'stop',
          },
        ],
        finally: [{ kind: 'send', bytes: encodeFrame(read(2)), onFailure: 'go-on' }],
      });
      const options = { timeout: PATIENT, line };
      const good = folder.write('runs', { sequence: sequence(2, 100) }, options);
      const hex = toHex(encodeFrame(read(1)));
      const last = toHex(encodeFrame(read(2)));
      const refusal = { ...read(1), direction: 'response', functionCode: 0x83, fields: { exceptionCode: 2 } } as const;
      const values = (...all: readonly number[]) => all.map((value) => reply(read(1), { registers: [value] }));
      await peer.expect(encodeFrame(read(1)), [
        ...values(40),
        encodeFrame(refusal),
        reply(read(2), { registers: [40, 0] }),
      ]);
      const ended = await runner.main(good, peer.port);
      expect(ended.code).not.toBe(0);
      expect(await peer.got(24)).toBe(hex + hex + last);
      const long = folder.write('waits', { sequence: sequence(1, 40) }, options);
      await peer.expect(encodeFrame(read(1)), values(...new Array(20).fill(39)));
      expect((await runner.main(long, peer.port)).code).not.toBe(0);
      await expect.poll(() => peer.got(24), POLLED).toMatch(new RegExp(`^(${hex}){2,6}${last}$`));
    });
  });
}

const VALUES: Readonly<Record<string, string>> = { True: '1', False: '0', true: '1', false: '0' };
