import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { type ProgramOptions, type ProgramSubject, writeProgram } from '../../src/codegen/index.ts';
import { encodeFrame, type FrameInput, fromHex, toHex } from '../../src/modbus/index.ts';
import { drive, driveOf, expectDriven, nastyNames, nastyProfile } from './c/programs.ts';
import { programCases, sequences } from './cases.ts';
import { namedPrograms } from './hostile.ts';
import { emptyFolder, expectProved, run, runTool, strictTool, withTools } from './tools.ts';

const [TOOL, ...WARNINGS] = strictTool('arduino');
const STAND_IN = join(import.meta.dirname, 'arduino');
const DRIVER = join(import.meta.dirname, 'c/driver.h');

/** What the device sends after its silence, in milliseconds; nothing if it is silent. */
interface Answer {
  readonly after: number;
  readonly hex: string;
}

withTools(['g++'], () => {
  const folder = emptyFolder('arduino');
  let ran = 0;

  /** A sketch as Arduino makes a program of it: prototypes of all its functions stand before the first. */
  function sketch(what: ProgramSubject, options: ProgramOptions = {}): string {
    const text = writeProgram('arduino', what, options).files[0]?.text ?? '';
    const heads = [...text.matchAll(/^((?:static )?[a-z][\w *]*\w\((?:[^;{}=]|\n)*\))\n\{/gm)];
    const first = heads[0]?.index ?? 0;
    const prototypes = heads.map(([, head]) => `${head};\n`).join('');
    return text.slice(0, first) + prototypes + text.slice(first);
  }

  async function compiled(file: string, text: string, main: string, answers: readonly Answer[] = []): Promise<string> {
    const table = answers.map(({ after, hex }) => {
      const bytes = fromHex(hex) ?? [];
      return `{${after * 1000}ULL, ${bytes.length}, {${[...bytes].join(', ')}}}`;
    });
    const core = `#include "Ethernet.h"
unsigned long long simulated_now;
int direction;
Monitor Serial;
EthernetClass Ethernet;
static const Answer table[] = {${[...table, '{0, 0, {0}}'].join(', ')}};
static Line answering()
{
    Line line;
    line.answers = table;
    line.many = ${table.length};
    return line;
}
Line Serial1 = answering();
`;
    writeFileSync(join(folder, `${file}.cpp`), `${core}\n#line 1 "${file}.ino"\n${text}\n#line 1 "driver"\n${main}\n`);
    const binary = join(folder, file);
    const { code, err } = await runTool(TOOL, [...WARNINGS, `-I${STAND_IN}`, '-o', binary, `${file}.cpp`], {
      cwd: folder,
      sources: [STAND_IN, DRIVER, join(folder, `${file}.cpp`)],
      output: binary,
    });
    expect(err).toBe('');
    expect(code).toBe(0);
    return binary;
  }

  const readRegisters: FrameInput = {
    transport: 'rtu',
    direction: 'request',
    unitId: 17,
    functionCode: 0x03,
    fields: { startAddress: 0x6b, quantity: 3 },
  };
  const sent = '1103006B00037687';
  const goodReply = '110306AE415652434049AD';
  const good = 'levels: good\n  registers[0] = 44609\n  registers[1] = 22098\n  registers[2] = 17216\n';
  const nobody = 'levels: fault -8, no reply\n';
  const once = (loops: number) => `int main()\n{\n    setup();\n${'    loop();\n'.repeat(loops)}    return 0;\n}`;

  describe.each(['rtu', 'ascii', 'tcp'] as const)('%s', (transport) => {
    test('makes the frames and checks the replies of all functions', async () => {
      const cases = programCases(transport);
      const text = sketch({ frames: cases }, { crc: transport === 'ascii' ? 'bitwise' : 'two-tables' });
      const main = `#include "${DRIVER}"\nint main()\n{\n    drive();\n    return 0;\n}`;
      const binary = await compiled(transport, text, main);
      const checks = driveOf(cases);
      expectDriven((await run(binary, [], { input: checks.input })).out, cases, checks);
      ran += cases.length;
    });
  });

  test('is said to have been compiled and run as it was', () => {
    expectProved('arduino', { how: 'compiled', command: 'g++ -std=c++11 -O2 -Wall -Wextra -Werror', frames: ran });
  });

  test('asks a device, and waits no longer than it may', async () => {
    const text = sketch(
      { request: readRegisters },
      { name: 'levels', timeout: 300, crc: 'table', line: { baud: 9600, parity: 'odd' } },
    );
    const answers = [
      { after: 250, hex: goodReply },
      { after: 0, hex: '' },
      { after: 290, hex: goodReply },
      { after: 5, hex: '118302C134' },
    ];
    const { out } = await run(await compiled('asks', text, once(4), answers), []);
    const refused = /levels: exception 2, [^\n]*\n/i.exec(out)?.[0] ?? '';
    const late = 'levels: fault -1, the reply is too short\n';
    expect(out).toBe(
      `begin 9600 36\nsent ${sent}\n${good}sent ${sent}\n${nobody}sent ${sent}\n${late}sent ${sent}\n${refused}`,
    );
    expect(refused).not.toBe('');
  });

  test('skips the echo, and ends a reply of unknown length after a silence', async () => {
    const canopen: FrameInput = {
      ...readRegisters,
      functionCode: 0x2b,
      fields: { meiType: 0x0d, meiData: '01020304' },
    };
    const reply = encodeFrame({ ...canopen, direction: 'response', fields: { meiType: 0x0d, meiData: '0A0B' } });
    const text = sketch(
      {
        frames: [
          { name: 'levels', request: readRegisters },
          { name: 'other', request: canopen },
        ],
      },
      { echo: true, comments: false },
    );
    expect(text).not.toMatch(/\/\/|\/\*/);
    const echo = toHex(encodeFrame(canopen));
    const main = `int main()\n{\n    setup();\n    loop();\n    printf("%llu\\n", simulated_now / 1000000);\n    return 0;\n}`;
    const answers = [
      { after: 0, hex: sent + goodReply },
      { after: 0, hex: echo + toHex(reply) },
    ];
    const { out } = await run(await compiled('echo', text, main, answers), []);
    expect(out).toMatch(
      new RegExp(`^begin 19200 26\nsent ${sent}\n${good.replace(/[[\]]/g, '\\$&')}sent ${echo}\nother: good\n`),
    );
    // The loop waits a second; the reply did not wait for its time-out.
    expect(out.trimEnd().split('\n').at(-1)).toBe('1');
  });

  test('carries out the sequences that come with the page, to their end and when a step fails', async () => {
    const [sequence] = sequences;
    if (sequence === undefined) throw new Error('no sequence');
    const write = (address: number, value: number) =>
      toHex(encodeFrame({ ...readRegisters, unitId: 6, functionCode: 6, fields: { address, value } }));
    const read = { ...readRegisters, unitId: 6, fields: { startAddress: 681, quantity: 1 } };
    const speed = (value: number) =>
      toHex(encodeFrame({ ...read, direction: 'response', fields: { registers: [value] } }));
    const [reference, run1, stop] = [write(683, 4096), write(682, 1), write(682, 0)];
    const main = `int main()\n{\n    setup();\n    printf("%llu\\n", simulated_now / 1000000);\n    return 0;\n}`;
    const at = (hex: string) => ({ after: 5, hex });
    const text = sketch({ sequence });
    const whole = [reference, run1, speed(0), speed(0xffff), speed(4000), stop].map(at);
    const { out } = await run(await compiled('sequence', text, main, whole), []);
    const frames = [...out.matchAll(/^sent (.*)$/gm)].map(([, hex]) => hex);
    const asked = toHex(encodeFrame(read));
    expect(frames).toEqual([reference, run1, asked, asked, asked, stop]);
    expect(out.trimEnd().split('\n').at(-1)).toBe('10');
    const fails = await run(await compiled('fails', text, main, [at(reference), { after: 0, hex: '' }, at(stop)]), []);
    expect([...fails.out.matchAll(/^sent (.*)$/gm)].map(([, hex]) => hex)).toEqual([reference, run1, stop]);
  });

  test('gives and takes values in units', async () => {
    const set = { ...readRegisters, functionCode: 0x06, fields: { address: 10, value: 0xff85 } };
    const state = { ...readRegisters, fields: { startAddress: 10, quantity: 7 } };
    const frames = [
      { name: 'set speed', request: set },
      { name: 'state', request: state },
    ];
    const text = sketch({ frames }, { profile: drive, units: true });
    const registers = [0xff85, 0x3fc0, 0, 1, 0x1170, 0xfffe, 0xffff];
    const reply = toHex(encodeFrame({ ...state, direction: 'response', fields: { registers } }));
    const written = toHex(encodeFrame(set));
    const answers = [written, reply].map((hex) => ({ after: 5, hex }));
    const { out } = await run(await compiled('units', text, once(1), answers), []);
    expect(out).toContain(`sent ${written}\nset speed: good\n`);
    expect(out).toContain('  speed = -12.30 Hz\n  current = 1.50 A\n  energy = 70000 Wh\n  torque = -2\n');
  });

  test('takes names of all kinds, and is a part of a sketch', async () => {
    const frames = nastyNames.map((name) => ({ name, request: readRegisters }));
    const names = { unit: 'F', start_address: 'byte', quantity: 'Größe "*/', crc: 'Serial1', checksum: 'crc' };
    await compiled('names', sketch({ frames }, { profile: nastyProfile, names }), once(0));
    const parts = (['bytes', 'build', 'check'] as const).map((part) =>
      sketch({ request: readRegisters }, { part, name: part }),
    );
    for (const [index, part] of parts.entries())
      await compiled(`part-${index}`, part, 'int main()\n{\n    return 0;\n}');
  });

  test('takes keywords of all languages, and whatever else is a name to somebody', async () => {
    const sources = namedPrograms.map(({ request, options }, index) => {
      const path = join(folder, `named-${index}.cpp`);
      writeFileSync(path, sketch({ request }, { part: 'check', ...options }));
      return path;
    });
    const args = [...WARNINGS, `-I${STAND_IN}`, '-include', 'Arduino.h', '-c', ...sources];
    const { code, err } = await runTool(TOOL, args, { cwd: folder, sources: [STAND_IN, ...sources] });
    expect([code, err]).toEqual([0, '']);
  });

  test('asks a server', async () => {
    const tcp: FrameInput = { ...readRegisters, transport: 'tcp', transactionId: 0x1234 };
    const reply = toHex(encodeFrame({ ...tcp, direction: 'response', fields: { registers: [1, 2, 0xffff] } }));
    const text = sketch({ request: tcp }, { name: 'levels', server: { host: 'plc "1"' } });
    const { out } = await run(await compiled('server', text, once(2), [{ after: 5, hex: reply }]), []);
    const asked = toHex(encodeFrame(tcp));
    expect(out).toBe(
      `connect plc "1" 502\nsent ${asked}\nlevels: good\n  registers[0] = 1\n  registers[1] = 2\n  registers[2] = 65535\nsent ${asked}\n${nobody}`,
    );
  });
});
