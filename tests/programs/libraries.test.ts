import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { writeFor } from '../../src/codegen/program.ts';
import type { Target } from '../../src/codegen/target.ts';
import { framewright } from '../../src/codegen/targets/framewright.ts';
import { minimalmodbus } from '../../src/codegen/targets/minimalmodbus.ts';
import { modbusSerial } from '../../src/codegen/targets/modbus-serial.ts';
import { pymodbus } from '../../src/codegen/targets/pymodbus.ts';
import { encodeFrame, type FrameInput, type Transport, toHex } from '../../src/modbus/index.ts';
import { PATIENT, type ProgramCase, programCases, repliesTo } from './cases.ts';
import { PEER_PORT, SLAVE_PORT } from './line.ts';
import { Peer, Runner } from './peers/peers.ts';
import { slaveCases, startSlave, toNobody } from './peers/slave.ts';
import { buildLibrary, cache, emptyFolder, expectProved, python, runTool, withTools } from './tools.ts';

/** A library and what is known of it. */
interface Library {
  readonly target: Target;
  readonly language: 'python' | 'javascript';
  /** Whether it chooses the transaction of TCP itself. */
  readonly ownTransaction: boolean;
  /** Whether what it has no call for is sent as raw bytes. */
  readonly sendsRaw: boolean;
  /** Functions that it has a call for on a serial line. */
  readonly offered: readonly number[];
}

type Line = Exclude<Transport, 'pdu'>;

const codeOf = ({ request }: ProgramCase) => request.functionCode ?? 0;

function testLibrary({ target, language, ownTransaction, sendsRaw, offered }: Library): void {
  const folder = emptyFolder(target.id);
  const ending = language === 'python' ? 'py' : 'mjs';
  let runner: Runner;
  let peer: Peer;
  beforeAll(async () => {
    if (target === framewright) await buildLibrary();
    runner = new Runner(language);
    peer = await Peer.start();
  });
  afterAll(() => {
    runner.end();
    peer.end();
  });

  const transports = target.transports.filter((one): one is Line => one !== 'pdu');
  const server = { port: PEER_PORT };
  const write = ({ request }: ProgramCase, timeout: number) =>
    writeFor(target, { request }, { timeout, line: { parity: 'none' }, server });
  const tried = Object.fromEntries(
    transports.map((transport) => {
      const cases = programCases(transport).map((one) => {
        const { files, notes } = write(one, PATIENT);
        return { one, text: files[0]?.text ?? '', isOffered: !notes.some(({ code }) => code === 'not-offered') };
      });
      return [transport, cases];
    }),
  );
  const sentBy = (transport: Line) => tried[transport]?.filter(({ isOffered }) => sendsRaw || isOffered) ?? [];
  test.each(transports)(
    `${target.name} sends the bytes of every request by %s, and takes its reply`,
    async (transport) => {
      for (const { one, text, isOffered } of sentBy(transport)) {
        const { name, request } = one;
        const good = repliesTo(request).find(({ what }) => what === 'good')?.bytes;
        // The reply to raw bytes is printed as it is, at the end of the time.
        const waits = good !== undefined && isOffered;
        const file = join(folder, `${transport}_${name.replaceAll(' ', '_')}.${ending}`);
        writeFileSync(file, waits ? text : (write(one, SHORT).files[0]?.text ?? ''));
        const sent = encodeFrame(request);
        await peer.expect(sent, good, { sameTransaction: ownTransaction && transport === 'tcp' });
        const { code, out } = await runner.main(file, transport === 'tcp' ? peer.host : peer.port);
        const got = await peer.got(sent.length);
        const own = ownTransaction && transport === 'tcp' ? 4 : 0;
        expect([name, got.slice(own)], `${code}: ${out}`).toEqual([name, toHex(sent).slice(own)]);
        if (waits) expect([name, code, out]).toEqual([name, 0, out]);
      }
    },
  );

  test(`${target.name} has calls for these functions, and is said to have sent what it sent`, () => {
    const found = new Set(tried['rtu']?.filter(({ isOffered }) => isOffered).map(({ one }) => codeOf(one)));
    expect([...found].sort((one, other) => one - other)).toEqual(offered);
    expectProved(target.id, { how: 'sent', frames: transports.flatMap(sentBy).length });
  });

  withTools(['libmodbus'], () => {
    const common = transports.filter((one) => one !== 'ascii');
    test.each(common)(`${target.name} asks libmodbus by %s`, async (transport) => {
      const slave = await startSlave();
      const ask = (name: string, request: FrameInput, timeout: number) => {
        const options = { timeout, line: { parity: 'none' }, server: { port: SLAVE_PORT } } as const;
        const file = join(folder, `${name}_${transport}.${ending}`);
        writeFileSync(file, writeFor(target, { request }, options).files[0]?.text ?? '');
        return runner.main(file, transport === 'tcp' ? slave.host : slave.serial);
      };
      const [, , registers] = slaveCases(transport);
      expect(registers?.name).toBe('registers');
      if (registers === undefined) return;
      expect(await ask('slave', registers.request, PATIENT)).toMatchObject({
        out: expect.stringMatching(/1008\D+1009\D*$/),
      });
      expect((await ask('nobody', toNobody(transport), 100)).code).not.toBe(0);
      slave.end();
    });
  });

  test(`${target.name} says that nothing came, and that the device refuses`, async () => {
    const request = { transport: 'rtu', direction: 'request', unitId: 6, functionCode: 0x03 } as const;
    const asked = { ...request, fields: { startAddress: 681, quantity: 2 } };
    const written = (timeout: number) => {
      const [text] = writeFor(target, { request: asked }, { timeout, line: { parity: 'none' } }).files;
      const file = join(folder, `refused_${timeout}.${ending}`);
      writeFileSync(file, text?.text ?? '');
      return file;
    };
    await peer.expect(encodeFrame(asked), undefined);
    expect((await runner.main(written(SHORT), peer.port)).code).not.toBe(0);
    const refused = encodeFrame({
      ...request,
      direction: 'response',
      functionCode: 0x83,
      fields: { exceptionCode: 2 },
    });
    await peer.expect(encodeFrame(asked), refused);
    const { code, out } = await runner.main(written(LONG), peer.port);
    expect(code).not.toBe(0);
    expect(`${code} ${out}`).toMatch(/exception.*2|illegal data address/i);
  });
}

/** Time-outs in milliseconds: for a refusal, which minimalmodbus takes for a part of a reply, and for what is only sent. */
const LONG = 5000;
const SHORT = 20;

const PUBLIC = [1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 15, 16, 17, 20, 21, 22, 23, 24, 43];
const PLAIN = [1, 2, 3, 4, 5, 6, 15, 16];

describe('libraries', () => {
  withTools(['python3', 'python'], () => {
    testLibrary({
      target: pymodbus,
      language: 'python',
      ownTransaction: true,
      sendsRaw: true,
      offered: PUBLIC.filter((code) => ![20, 21, 24].includes(code)),
    });
    testLibrary({
      target: minimalmodbus,
      language: 'python',
      ownTransaction: false,
      sendsRaw: true,
      offered: PLAIN,
    });
    test.each([125, 126])('minimalmodbus sends %i coils', async (many) => {
      const fields = { startAddress: 0, bits: Array.from({ length: many }, (_, index) => index % 2) };
      const request = { transport: 'rtu', direction: 'request', unitId: 6, functionCode: 0x0f, fields } as const;
      const { files, notes } = writeFor(minimalmodbus, { request }, { timeout: 200, line: { parity: 'none' } });
      expect(notes.map(({ code }) => code)).toEqual(many > 125 ? ['not-offered'] : []);
      const file = join(cache, 'run', minimalmodbus.id, `coils_${many}.py`);
      writeFileSync(file, files[0]?.text ?? '');
      const [peer, runner] = [await Peer.start(), new Runner('python')];
      const sent = encodeFrame(request);
      await peer.expect(
        sent,
        encodeFrame({ ...request, direction: 'response', fields: { startAddress: 0, quantity: many } }),
      );
      await runner.main(file, peer.port);
      expect(await peer.got(sent.length)).toBe(toHex(sent));
      runner.end();
      peer.end();
    });
    test('the programs of Python pass mypy --strict', async () => {
      const folders = [pymodbus, minimalmodbus].map(({ id }) => join(cache, 'run', id));
      for (const folder of folders) {
        // pymodbus has functions without types, minimalmodbus says of none that they have types.
        const lax = ['--allow-untyped-calls', '--disable-error-code=import-untyped'];
        const flags = ['--strict', ...lax, '--cache-dir', join(cache, 'mypy')];
        const { out, err } = await runTool(python('mypy'), [...flags, folder], { sources: [folder] });
        expect(`${out}${err}`).toMatch(/^Success/);
      }
    });
  });
  testLibrary({
    target: modbusSerial,
    language: 'javascript',
    ownTransaction: true,
    sendsRaw: false,
    offered: [...PLAIN, 43],
  });
  testLibrary({
    target: framewright,
    language: 'javascript',
    ownTransaction: false,
    sendsRaw: true,
    offered: [...PUBLIC, 65],
  });
});
