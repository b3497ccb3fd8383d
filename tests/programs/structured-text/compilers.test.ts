import { existsSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { expect, test } from 'vitest';
import { writeProgram } from '../../../src/codegen/program.ts';
import { programCases, sequences } from '../cases.ts';
import { emptyFolder, full, python, run, runTool, withTools } from '../tools.ts';

/** Parses each unit by itself, as blark takes much longer for a whole file, and says which could not be parsed, and why. */
const PARSE = `
import re, sys
from blark.parse import new_parser, parse_source_code
parser = new_parser()
unit = re.compile(r'^(TYPE|FUNCTION_BLOCK|FUNCTION)\\b.*?^END_\\1$', re.M | re.S)
for name in sys.argv[1:]:
    text = open(name, encoding='utf-8').read()
    # blark takes values for an array only where its type is written out, IEC 61131-3 also behind the type's name (B.1.4.3).
    arrays = dict(re.findall(r'^ *(\\w+) : (ARRAY[^;]*);', text, re.MULTILINE))
    text = re.sub(r': (\\w+) := \\[', lambda found: f': {arrays[found[1]]} := [', text)
    for found in unit.finditer(text):
        try:
            parse_source_code(found.group(0), parser=parser).transform()
        except Exception as error:
            print(name, found.group(0)[:40], type(error).__name__, error)
`;

const folder = emptyFolder('structured-text');
const file = (name: string, text: string): string => {
  writeFileSync(join(folder, name), text);
  return name;
};
const textOf = (...given: Parameters<typeof writeProgram> extends [string, ...infer Rest] ? Rest : never): string =>
  writeProgram('structured-text', ...given).files[0]?.text ?? '';

const request = (transport: 'rtu' | 'ascii' | 'tcp', wanted: string) => {
  const found = programCases(transport).find(({ name }) => name === wanted);
  if (!found) throw new Error(wanted);
  return { request: found.request };
};

/** Programs that have everything in them that is ever written; the first ones are short. */
const samples: Readonly<Record<string, () => string>> = {
  build: () => textOf(request('rtu', 'write coils'), { part: 'build', crc: 'bitwise', comments: false }),
  broadcast: () => textOf(request('rtu', 'broadcast')),
  sequence: () => textOf({ sequence: sequences[0] as NonNullable<(typeof sequences)[0]> }),
  // Without tables: blark takes minutes, and 8 GB, for an array of 256 numbers.
  list: () => textOf(request('rtu', 'write coils'), { echo: true }),
  constant: () => textOf(request('rtu', 'raw function'), { comments: false }),
  tcp: () => textOf(request('tcp', 'read and write registers'), { crc: 'table' }),
  ascii: () => textOf(request('ascii', 'read fifo queue')),
};

const files = () => Object.entries(samples).map(([name, text]) => file(`${name}.st`, text()));

withTools(['python3', 'python'], () => {
  test('blark parses the programs, and refuses what is not Structured Text', async () => {
    file('parse.py', PARSE);
    const broken = file(
      'broken.st',
      'FUNCTION F : WORD\nVAR_INPUT\n    A : WORD;\nEND_VAR\nF := A >> 1;\nEND_FUNCTION\n',
    );
    const texts = [broken, ...(full ? files() : files().slice(0, 1))];
    const sources = ['parse.py', ...texts].map((name) => join(folder, name));
    const { code, out, err } = await runTool(python(), ['parse.py', ...texts], { cwd: folder, sources });
    expect([code, err]).toEqual([0, '']);
    expect(out).toMatch(/^broken\.st FUNCTION[^\n]*\n/);
    expect(out).not.toMatch(/^(?!broken)\w+\.st/m);
  });
});

/** matiec, the compiler of OpenPLC, is in no package: it is used where somebody has it, with its library beside it. */
const matiec = (process.env['PATH'] ?? '').split(delimiter).find((path) => existsSync(join(path, 'iec2c')));

test(
  matiec === undefined ? 'matiec is not here: its rules are those of the machine' : 'matiec compiles the programs',
  async () => {
    if (matiec === undefined) return;
    const library = [join(matiec, 'lib'), join(matiec, '../share/matiec/lib')].find((path) => existsSync(path)) ?? '';
    const texts = full
      ? (['rtu', 'ascii', 'tcp'] as const).flatMap((transport) =>
          programCases(transport).map(({ request }, index) =>
            file(
              `${transport}${index}.st`,
              textOf({ request }, index % 2 === 0 ? {} : { crc: 'table', comments: false }),
            ),
          ),
        )
      : files();
    for (const text of texts) {
      const { code, err } = await run(join(matiec, 'iec2c'), ['-I', library, '-T', folder, text], { cwd: folder });
      expect([text, code, err]).toEqual([text, 0, '']);
    }
  },
);
