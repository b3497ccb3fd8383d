import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { describe, expect, test } from 'vitest';
import { type ProgramOptions, type ProgramSubject, writeProgram } from '../../src/codegen/index.ts';
import { encodeFrame, type FrameInput, fromHex, toHex } from '../../src/modbus/index.ts';
import type { Sequence } from '../../src/sequences/index.ts';
import { drive, driveOf, expectDriven, nastyNames, nastyProfile } from './c/programs.ts';
import { PATIENT, programCases, sequences } from './cases.ts';
import { namedPrograms } from './hostile.ts';
import { SLAVE_PORT } from './line.ts';
import { expectServed, slaveCases, startSlave, toNobody } from './peers/slave.ts';
import { emptyFolder, expectProved, run, runTool, strictTool, withTools } from './tools.ts';

const [TOOL, ...WARNINGS] = strictTool('c');
/** A time-out in milliseconds, of programs that get a reply, and then none. */
const MIDDLE = 3000;
const DRIVER = join(import.meta.dirname, 'c/driver.h');

withTools(['gcc', 'python3'], () => {
  const folder = emptyFolder('c');
  let ran = 0;

  /** Writes a program; gives its text. */
  function written(file: string, what: ProgramSubject, options: ProgramOptions = {}): string {
    const text = writeProgram('c', what, options).files[0]?.text ?? '';
    writeFileSync(join(folder, file), text);
    return text;
  }

  async function gcc(...args: readonly string[]): Promise<void> {
    const files = args.filter((name) => name.endsWith('.c')).flatMap((name) => [name, name.replace('driven-', '')]);
    const sources = [DRIVER, ...files.map((name) => join(folder, name))];
    const output = args.includes('-o') ? args[args.indexOf('-o') + 1] : undefined;
    const { code, err } = await runTool(TOOL, [...WARNINGS, ...args], { cwd: folder, sources, output });
    expect(err).toBe('');
    expect(code).toBe(0);
  }

  /** Compiles a program with a main of the test's; its own is `program_main`. */
  async function driven(file: string, main: string): Promise<string> {
    const source = `#define main program_main\n#include "${file}"\n#undef main\n${main}\n`;
    writeFileSync(join(folder, `driven-${file}`), source);
    const binary = join(folder, file.replace('.c', ''));
    await gcc('-o', binary, `driven-${file}`);
    return binary;
  }

  const readRegisters: FrameInput = {
    transport: 'rtu',
    direction: 'request',
    unitId: 17,
    functionCode: 0x03,
    fields: { startAddress: 0x6b, quantity: 3 },
  };
  /** Unit 17: registers 107 to 109 are 0xAE41, 0x5652 and 0x4340 (SL 2.5.1, AP 6.3). */
  const goodReply = '110306AE415652434049AD';

  const request = (functionCode: number, fields: FrameInput['fields'], unitId = 17): FrameInput => ({
    transport: 'rtu',
    direction: 'request',
    unitId,
    functionCode,
    fields,
  });

  /** Runs a program on a pseudo-terminal on which a device answers; gives what the device received, too. */
  async function onTerminal(binary: string, answers: readonly string[]) {
    const device = spawn('python3', [join(import.meta.dirname, 'c/pseudo-terminal.py'), ...answers]);
    const lines = createInterface(device.stdout)[Symbol.asyncIterator]();
    const next = async () => String((await lines.next()).value);
    const ran = await run(binary, [await next()]);
    const received: string[] = [];
    for (const _ of answers) received.push(await next());
    device.stdin.end();
    await once(device, 'close');
    return { ...ran, received };
  }

  describe.each(['rtu', 'ascii', 'tcp'] as const)('%s', (transport) => {
    test('makes the frames and checks the replies of all functions', async () => {
      const cases = programCases(transport);
      written(`${transport}.c`, { frames: cases }, { crc: 'two-tables' });
      const main = `#include "${DRIVER}"\nint main(void)\n{\n    drive();\n    return 0;\n}`;
      const checks = driveOf(cases);
      const { out } = await run(await driven(`${transport}.c`, main), [], { input: checks.input });
      expectDriven(out, cases, checks);
      ran += cases.length;
    });
  });

  test('is said to have been compiled and run as it was', () => {
    expectProved('c', { how: 'compiled', command: 'gcc -std=c99 -O2 -Wall -Wextra -Werror -pedantic', frames: ran });
  });

  test('calculates the CRC bit by bit and with a table', async () => {
    const cases = programCases('rtu', 0).slice(0, 12);
    for (const crc of ['bitwise', 'table'] as const) {
      const text = written(`${crc}.c`, { frames: cases }, { crc, comments: false });
      expect(text).not.toMatch(/\/\/|\/\*/);
      const binary = join(folder, crc);
      await gcc('-o', binary, `${crc}.c`);
      const { out } = await run(binary, ['--bytes']);
      const bytes = out.replaceAll(' ', '').trimEnd().split('\n');
      expect(bytes).toEqual(cases.map((one) => toHex(encodeFrame(one.request))));
    }
  });

  test('is a part of a program of one’s own', async () => {
    const name = 'read';
    const bytes = written('bytes.c', { request: readRegisters }, { part: 'bytes', name });
    written('build.c', { request: readRegisters }, { part: 'build', name });
    written('check.c', { request: readRegisters }, { part: 'check', name });
    written('pdu.c', { request: { ...readRegisters, transport: 'pdu' } }, { name });
    expect([...bytes.matchAll(/0x([\dA-F]{2}),?/g)].map(([, digits]) => digits).join('')).toBe('1103006B00037687');
    await gcc('-c', 'bytes.c', 'build.c', 'pdu.c');
    const main = `
#include <stdio.h>
int main(void)
{
    uint8_t frame[8];
    uint16_t registers[3];
    const uint8_t reply[] = {${[...(fromHex(goodReply) ?? [])].join(', ')}};
    int length = build_read(frame, 17, 107, 3);
    for (int i = 0; i < length; i++) {
        printf("%02X", frame[i]);
    }
    printf(" %d", check_read(frame, reply, sizeof reply, registers));
    printf(" %04X %04X %04X", registers[0], registers[1], registers[2]);
    printf(" %d %d %s\\n", check_read(frame, reply, 0, registers), check_read(frame, reply, 9, registers), fault_name(-8));
    return 0;
}`;
    const { out } = await run(await driven('check.c', main), []);
    expect(out).toBe('1103006B00037687 0 AE41 5652 4340 -8 -1 no reply\n');
  });

  test('says what it does with --bytes and --check', async () => {
    written('one.c', { request: readRegisters }, { name: 'levels' });
    const binary = join(folder, 'one');
    await gcc('-o', binary, 'one.c');
    expect(await run(binary, ['--bytes'])).toMatchObject({ code: 0, out: '11 03 00 6B 00 03 76 87\n' });
    expect(await run(binary, ['--check', goodReply])).toMatchObject({
      code: 0,
      out: 'levels: good\n  registers[0] = 44609\n  registers[1] = 22098\n  registers[2] = 17216\n',
    });
    const refused = await run(binary, ['--check', '11 83 02 C1 34']);
    expect(refused.code).toBe(1);
    expect(refused.out).toMatch(/^levels: exception 2, .*data address\n$/i);
    expect((await run(binary, [join(folder, 'nothing')])).code).toBe(1);
  });

  test('gives and takes values in units', async () => {
    const frames = [
      { name: 'set speed', request: request(0x06, { address: 10, value: 0xff85 }) },
      { name: 'set speeds', request: request(0x10, { startAddress: 10, registers: [155] }) },
      { name: 'state', request: request(0x03, { startAddress: 10, quantity: 7 }) },
    ];
    const text = written('units.c', { frames }, { profile: drive, units: true });
    expect(text).toContain('hz_to_raw(-12.3)');
    expect(text).toContain('hz_to_raw(15.5)');
    const binary = join(folder, 'units');
    await gcc('-o', binary, 'units.c', '-lm');
    const bytes = await run(binary, ['--bytes']);
    expect(bytes.out.replaceAll(' ', '').trimEnd().split('\n')).toEqual(
      frames.map((one) => toHex(encodeFrame(one.request))),
    );
    // -12.3 Hz, 1.5 A, 70000 Wh, -2.
    const registers = [0xff85, 0x3fc0, 0, 1, 0x1170, 0xfffe, 0xffff];
    const reply = encodeFrame({ ...request(0x03, { registers }), direction: 'response' });
    const { out } = await run(binary, ['--check', toHex(reply), '3']);
    expect(out.split('\n').filter((line) => !line.includes('['))).toEqual([
      'state: good',
      '  speed = -12.3 Hz',
      '  current = 1.5 A',
      '  energy = 70000 Wh',
      '  torque = -2',
      '',
    ]);
  });

  test('takes keywords of all languages, and whatever else is a name to somebody', async () => {
    const files = namedPrograms.map(({ request, options }, index) => {
      written(`named-${index}.c`, { request }, { part: 'check', ...options });
      return `named-${index}.c`;
    });
    await gcc('-c', ...files);
  });

  test('takes names of all kinds', async () => {
    written(
      'names.c',
      { frames: nastyNames.map((name) => ({ name, request: readRegisters })) },
      {
        profile: nastyProfile,
        line: { port: '/dev/"tty\\' },
        names: { unit: 'int', start_address: '3 x', quantity: 'Größe "*/', crc: 'crc_16', checksum: 'errno' },
      },
    );
    const binary = join(folder, 'names');
    await gcc('-o', binary, 'names.c');
    const { out } = await run(binary, ['--bytes']);
    expect(out).toBe('11 03 00 6B 00 03 76 87\n'.repeat(nastyNames.length));
  });

  test('asks a device on a serial port, and waits no longer than it may', async () => {
    const canopen = request(0x2b, { meiType: 0x0d, meiData: '01020304' });
    const toAll = request(0x06, { address: 1, value: 3 }, 0);
    const silent = encodeFrame({ ...canopen, direction: 'response', fields: { meiType: 0x0d, meiData: '0A0B' } });
    written(
      'serial.c',
      {
        frames: [
          { name: 'levels', request: readRegisters },
          { name: 'unknown length', request: canopen },
          { name: 'to all', request: toAll },
          { name: 'nobody', request: readRegisters },
        ],
      },
      { timeout: MIDDLE, line: { baud: 57_600, parity: 'none', stopBits: 2 } },
    );
    const binary = join(folder, 'serial');
    await gcc('-o', binary, 'serial.c');
    const { out, received, code } = await onTerminal(binary, [
      `8:${goodReply.slice(0, 6)},${goodReply.slice(6)}`,
      `${encodeFrame(canopen).length}:${toHex(silent)}`,
      '8:',
      '8:',
    ]);
    expect(received.map((hex) => hex.toUpperCase())).toEqual([
      '1103006B00037687',
      toHex(encodeFrame(canopen)),
      toHex(encodeFrame(toAll)),
      '1103006B00037687',
    ]);
    expect(out).toBe(
      'levels: good\n  registers[0] = 44609\n  registers[1] = 22098\n  registers[2] = 17216\nunknown length: good\n  mei_data[0] = 10\n  mei_data[1] = 11\nto all: sent\nnobody: fault -8, no reply\n',
    );
    expect(code).toBe(1);
  });

  withTools(['libmodbus'], () => {
    test.each(['rtu', 'tcp'] as const)('asks libmodbus by %s', async (transport) => {
      const slave = await startSlave();
      const where = transport === 'tcp' ? slave.host : slave.serial;
      const ask = async (file: string, what: ProgramSubject, timeout: number) => {
        written(`${file}.c`, what, { timeout, line: { parity: 'none' }, server: { port: SLAVE_PORT } });
        await gcc('-o', join(folder, file), `${file}.c`);
        return run(join(folder, file), [where]);
      };
      expectServed((await ask(`slave-${transport}`, { frames: slaveCases(transport) }, PATIENT)).out);
      const nobody = await ask(`nobody-${transport}`, { request: toNobody(transport) }, 150);
      expect(nobody).toMatchObject({ code: 1, out: expect.stringMatching(/fault -8, no reply/) });
      slave.end();
    });
  });

  test('carries out a sequence behind an adapter with an echo', async () => {
    const write = (value: number) => encodeFrame(request(0x06, { address: 682, value }, 6));
    const [on, off] = [write(1), write(0)];
    const until = {
      kind: 'until',
      unit: 6,
      table: 'holding-register',
      address: 681,
      type: 'i16',
      order: 'ABCD',
      relation: '≥',
      value: 4000,
      interval: 20,
      onFailure: 'stop',
    } as const;
    const sequence: Sequence = {
      transport: 'rtu',
      steps: [
        { kind: 'repeat', times: 2, steps: [{ kind: 'send', bytes: on, onFailure: 'stop' }] },
        { kind: 'wait', duration: 10 },
        { ...until, timeout: PATIENT },
        { ...until, address: 700, timeout: 100 },
        { kind: 'send', bytes: on, onFailure: 'stop' },
      ],
      finally: [{ kind: 'send', bytes: off, onFailure: 'stop' }],
    };
    written('sequence.c', { sequence }, { echo: true, timeout: MIDDLE });
    const binary = join(folder, 'sequence');
    await gcc('-o', binary, 'sequence.c');
    const read = (address: number) => toHex(encodeFrame(request(0x03, { startAddress: address, quantity: 1 }, 6)));
    const speed = (value: number) =>
      toHex(encodeFrame({ ...request(0x03, { registers: [value] }, 6), direction: 'response' }));
    const echoed = (sent: string, reply: string) => `8:${sent}${reply}`;
    const answers = [
      echoed(toHex(on), toHex(on)),
      echoed(toHex(on), toHex(on)),
      echoed(read(681), speed(0xffff)),
      echoed(read(681), speed(4000)),
      // Never in time: what follows is left out, but for what is done at last.
      `8:${read(700)}`,
      echoed(toHex(off), toHex(off)),
    ];
    const { out, received, code } = await onTerminal(binary, answers);
    expect(received.map((hex) => hex.toUpperCase())).toEqual([
      toHex(on),
      toHex(on),
      read(681),
      read(681),
      read(700),
      toHex(off),
    ]);
    expect(out).toContain('did not hold in time');
    expect(code).toBe(1);
  });

  test('writes the sequences that come with the page', async () => {
    for (const [index, sequence] of sequences.entries()) {
      written(`built-in-${index}.c`, { sequence });
      await gcc('-o', join(folder, `built-in-${index}`), `built-in-${index}.c`);
    }
  });

  test('asks a server', async () => {
    const tcp: FrameInput = { ...readRegisters, transport: 'tcp', transactionId: 0x1234 };
    const registers = [1, 2, 0xffff];
    const reply = encodeFrame({ ...tcp, direction: 'response', fields: { registers } });
    const received: string[] = [];
    const server = createServer((socket) =>
      socket.on('data', (bytes) => {
        received.push(toHex(bytes));
        if (received.length === 1) socket.write(reply);
      }),
    );
    await once(server.listen(0, '127.0.0.1'), 'listening');
    const address = server.address();
    const port = typeof address === 'object' ? address?.port : undefined;
    const frames = ['levels', 'nobody'].map((name) => ({ name, request: tcp }));
    written('server.c', { frames }, { timeout: MIDDLE, server: { host: '127.0.0.1', port } });
    const binary = join(folder, 'server');
    await gcc('-o', binary, 'server.c');
    const { out, code } = await run(binary, []);
    server.close();
    expect(received).toEqual([toHex(encodeFrame(tcp)), toHex(encodeFrame(tcp))]);
    expect(out).toBe(
      'levels: good\n  registers[0] = 1\n  registers[1] = 2\n  registers[2] = 65535\nnobody: fault -8, no reply\n',
    );
    expect(code).toBe(1);
  });
});
