import { describe, expect, test } from 'vitest';
import { crcWays, programParts } from '../../src/codegen/options.ts';
import { type ProgramSubject, writeFor } from '../../src/codegen/program.ts';
import { powershell } from '../../src/codegen/targets/powershell.ts';
import { encodeFrame, fromHex } from '../../src/modbus/index.ts';
import { programCases, sequences } from './cases.ts';

/** Comments, and texts between single and double quotes, in which the same quote twice is one. */
const TOKEN = /#[^\n]*|(['\u2018-\u201b])(?:[^'\u2018-\u201b]|['\u2018-\u201b]{2})*['\u2018-\u201b]|"(?:[^"`]|`.)*"/g;
const AUTOMATIC = ['true', 'false', 'null', '_', 'ErrorActionPreference'];

/** What PowerShell would not take, or would take for something else. */
function faultsOf(text: string): readonly string[] {
  const faults: string[] = [];
  const inside = text.match(/"(?:[^"`]|`.)*"/g)?.join(' ') ?? '';
  const code = text.replace(TOKEN, (token) => (token.startsWith('#') ? '' : '0'));
  for (const wrong of ['&&', '||', '>>', '<<', '==', '!=', '^', '\u2018', '\u2019', '"', "'"])
    if (code.includes(wrong)) faults.push(wrong);
  const open: string[] = [];
  for (const mark of code.match(/[()[\]{}]/g) ?? []) {
    if ('([{'.includes(mark)) open.push(mark);
    else if (`${open.pop()}${mark}`.match(/^(\(\)|\[\]|\{\})$/) === null) faults.push(`${mark} closes nothing`);
  }
  if (open.length > 0) faults.push(`${open.join('')} open`);
  const declared = [...code.matchAll(/(?:\]\s*|\(|^\s*|, )\$(\w+)(?=\s*(?:=[^=]|[,)]))/gm)].map(([, name = '']) =>
    name.toLowerCase(),
  );
  const known = new Set([...declared, ...AUTOMATIC.map((name) => name.toLowerCase())]);
  for (const [, name = ''] of `${code} ${inside}`.matchAll(/\$(\w+)/g))
    if (!known.has(name.toLowerCase())) faults.push(`$${name} is not declared`);
  const functions = [...code.matchAll(/^function (\w+)/gm)].map(([, name]) => name);
  if (new Set(functions.map((name) => name?.toLowerCase())).size < functions.length) faults.push('a function twice');
  for (const [, name] of code.matchAll(/(?:^\s*|\(|= )((?:Build|Check|Show|Send|Read|Crc|Lrc)\w*) /gm))
    if (!functions.includes(name)) faults.push(`no function ${name}`);
  return faults;
}

const write = (what: ProgramSubject, options = {}) => writeFor(powershell, what, options).files[0]?.text ?? '';

describe('PowerShell', () => {
  test('the rules find what is wrong', () => {
    expect(faultsOf("$a = 'it''s' # (\nif ($a -eq 1) { }")).toEqual([]);
    expect(faultsOf("$a = 'it's'")).not.toEqual([]);
    expect(faultsOf('if ($b == 1) {')).toEqual(['==', '{ open', '$b is not declared']);
  });

  test('every program keeps the rules', () => {
    for (const transport of ['rtu', 'ascii', 'tcp'] as const) {
      programCases(transport).forEach(({ name, request }, index) => {
        const options = {
          crc: crcWays[index % crcWays.length],
          comments: index % 5 !== 4,
          echo: index % 7 === 6,
          part: programParts[3 - (index % 4)],
        };
        expect([name, faultsOf(write({ request }, options))]).toEqual([name, []]);
      });
    }
    for (const sequence of sequences) expect(faultsOf(write({ sequence }))).toEqual([]);
  });

  test('names and texts of the user cannot break out', () => {
    const request = {
      transport: 'rtu',
      direction: 'request',
      unitId: 6,
      functionCode: 0x06,
      fields: { address: 683, value: 4096 },
    } as const;
    for (const text of [
      "it's",
      '\u2019; Remove-Item x; \u2019',
      '$(Remove-Item x)',
      '`',
      '"',
      '#>',
      'a\nRemove-Item x',
      'Error',
      'input',
      'Switch',
      '3rd',
      'größe',
    ]) {
      const options = {
        name: text,
        names: { value: text, address: text },
        line: { port: text },
        server: { host: text },
      };
      const program = write({ request }, options);
      expect([text, faultsOf(program)]).toEqual([text, []]);
      expect(program.split('\n').filter((line) => line.startsWith('Remove-Item'))).toEqual([]);
    }
  });

  test('the bytes of a constant are those of the frame, a line a field', () => {
    const request = {
      transport: 'rtu',
      direction: 'request',
      unitId: 6,
      functionCode: 0x06,
      fields: { address: 683, value: 4096 },
    } as const;
    const text = write({ request }, { part: 'bytes' });
    const pairs =
      text
        .replace(/#.*/g, '')
        .match(/0x([0-9A-F]{2})/g)
        ?.map((pair) => pair.slice(2)) ?? [];
    expect(fromHex(pairs.join(''))).toEqual(encodeFrame(request));
    expect(text).toContain('0x02, 0xAB,');
  });
});
