import fc from 'fast-check';
import { expect, test } from 'vitest';
import { deviceTraits, readProfiles, readTable, writeProfiles } from '../../../src/devices/index.ts';
import {
  readAddress,
  readBytes,
  readDuration,
  readNumber,
  readNumbers,
  readOctets,
  readValues,
} from '../../../src/notation/index.ts';
import { builtInSequences, readSequence, readSequences, writeSequences } from '../../../src/sequences/index.ts';
import { readSaved } from '../../../src/workbench/examples/saved-file.ts';
import { readLink } from '../../../src/workbench/index.ts';

/** What every object has, as anybody may have named something. */
const inherited = Object.getOwnPropertyNames(Object.prototype);
const hostile = fc.constantFrom(...inherited, 'prototype', 'name', 'length', 'call');

const usualParents: readonly unknown[] = [Object.prototype, Array.prototype, Uint8Array.prototype, null];

/** Whether it holds data alone, of objects that are their own: no function, and no prototype but the usual ones. */
function expectData(value: unknown): void {
  if (typeof value === 'function') expect.unreachable(`${value} is a function`);
  if (typeof value !== 'object' || value === null) return;
  const parent: unknown = Object.getPrototypeOf(value);
  if (!usualParents.includes(parent)) expect(usualParents).toContain(parent);
  if (!(value instanceof Uint8Array)) for (const name of Object.keys(value)) expectData(Reflect.get(value, name));
}

/** Anything may be said of the answer but that it is more than data, or that objects have changed by it. */
const holds = (name: string, read: (name: string) => unknown) => {
  expectData(read(name));
  expect(Object.getOwnPropertyNames(Object.prototype)).toEqual(inherited);
};

const HEADER = ['name', 'table', 'address', 'type', 'order', 'count', 'access', 'names', 'number'];
const SETTINGS = ['#id', '#name', '#source', '#convention', '#serial', '#trait', '#note'];

test('in any cell of a table of a device', () => {
  const cells = fc.array(fc.oneof(hostile, fc.constantFrom('', '1', 'hr', 'u16', ...HEADER, ...SETTINGS)), {
    maxLength: 10,
  });
  fc.assert(
    fc.property(hostile, fc.array(cells, { maxLength: 4 }), fc.nat(8), (name, rows, at) => {
      const usual = ['a', 'hr', '1', 'u16', 'ABCD', '1', 'r', '1=a', ''];
      const table = [[`#${name}`, name], ['#trait', name], ...rows, HEADER, usual.with(at, name)];
      holds(name, () =>
        readTable(
          table.map((each, index) => ({ line: index + 1, cells: each })),
          name,
        ),
      );
    }),
  );
});

/** The text of JSON with each of its strings, key or value, replaced by the name. */
function* spoilt(text: string, name: string): Generator<string> {
  for (const { index, 0: old } of text.matchAll(/"(?:[^"\\]|\\.)*"/g))
    yield text.slice(0, index) + JSON.stringify(name) + text.slice(index + old.length);
}

const profiles = writeProfiles([
  {
    id: 'own',
    name: 'own',
    source: '',
    convention: 'zero-based',
    serial: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 },
    traits: deviceTraits.slice(0, 1),
    registers: readTable(
      [
        { line: 1, cells: HEADER },
        { line: 2, cells: ['a', 'hr', '1', 'u16', 'ABCD', '1', 'r', '1=a', ''] },
      ],
      '',
    ).profile.registers,
    notes: ['a note'],
  },
]);

const usual = ['constructor', '__proto__', 'toString', 'hasOwnProperty'];

test.each(usual)('in any key and value of a file of devices: %s', (name) => {
  for (const text of spoilt(profiles, name)) holds(text, readProfiles);
});

test.each(usual)('in any key and value of a file of sequences: %s', (name) => {
  for (const text of spoilt(writeSequences(builtInSequences), name)) {
    const reading = readSequences(text, () => undefined);
    holds(text, () => reading);
    for (const entry of reading.kind === 'sequences' ? reading.entries : [])
      if (entry.kind === 'sequence') holds(name, () => readSequence(entry.sequence));
  }
});

test('in any part of a link, and in saved frames', () => {
  const part = fc.oneof(hostile, fc.constantFrom('rtu', 'request', 'functionCode', '6', 'force', 'subRequests[0]'));
  fc.assert(
    fc.property(fc.array(part, { minLength: 3, maxLength: 9 }), (parts) => {
      const [transport = '', kind = '', ...others] = parts;
      const query = others.map((one, index) => `${index % 2 === 0 ? 'force.' : ''}${one}=${others.at(-1)}`).join('&');
      const link = `${transport}/${kind}?${query}&${others.join('.')}=1`;
      holds(link, readLink);
      const row = { name: transport, link, [kind]: transport };
      holds(link, () => readSaved(JSON.stringify({ format: 'framewright-frames', version: 1, frames: [row] })));
    }),
  );
});

test('where a number, a value, an address or bytes are expected', () => {
  for (const name of [...inherited, 'prototype', 'length']) {
    expect(readNumber(name)).toBeUndefined();
    expect(readNumbers(name).kind).toBe('wrong');
    expect(readDuration(name)).toBeUndefined();
    expect(readAddress(name)).toEqual([]);
    holds(name, readOctets);
    holds(name, (text) => readBytes(text));
    holds(name, (text) => readValues(text));
    holds(name, (text) => readValues(`${text}: ${text} as ${text}`));
  }
});
