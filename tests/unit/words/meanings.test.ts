import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import {
  type Direction,
  decodeFrame,
  fieldByName,
  fieldsOf,
  functionCodes,
  partsOf,
  type Transport,
} from '../../../src/modbus/index.ts';
import { languages } from '../../../src/words/index.ts';
import { hex } from '../modbus/frames.ts';

const words = await languages.en.tools();

/** A frame, and what is to be said of each of its fields; what items and fields of groups say stands further in. */
interface Said {
  readonly transport: Transport;
  readonly direction: Direction;
  readonly pairs: string;
  readonly lines: readonly string[];
}

/** The table: each sentence was checked against the bytes by hand. */
const table: readonly Said[] = readFileSync('tests/vectors/meanings.txt', 'utf8')
  .split(/\n(?=\S)/)
  .map((frame) => {
    const [head = '', ...lines] = frame.trimEnd().split('\n');
    const [, transport, direction, pairs = ''] = /^(\w+) (\w+) (.*)$/.exec(head) ?? [];
    return {
      transport: transport as Transport,
      direction: direction as Direction,
      pairs,
      lines: lines.map((line) => line.slice(2)),
    };
  });

function sentencesOf({ transport, direction, pairs }: Said): string[] {
  const bytes = hex(pairs);
  const reading = decodeFrame(bytes, { transport, direction });
  return reading.spans.flatMap((span) => {
    const kind = fieldByName(reading, span.name)?.kind ?? span.kind;
    const items = partsOf(reading, bytes, span).flatMap(({ index, values, parts }) => [
      `  ${words.itemMeaning({ reading, name: span.name, kind, index, values })}`,
      ...parts.map(({ name }) => `    ${words.groupFieldMeaning(name, values)}`),
    ]);
    return [`${span.name}: ${words.meaning({ reading, bytes, span })}`, ...items];
  });
}

describe('what is said of the fields of a frame', () => {
  it.each(table.map((said) => [`${said.transport} ${said.direction} ${said.pairs}`, said] as const))(
    '%s',
    (_, said) => {
      expect(sentencesOf(said)).toEqual(said.lines);
    },
  );

  it('is in the table for every field of every function', () => {
    const inTable = new Set(
      table.flatMap(({ transport, direction, pairs }) => {
        const { spans, functionCode } = decodeFrame(hex(pairs), { transport, direction });
        return spans.map(({ name }) => `${functionCode} ${direction} ${name}`);
      }),
    );
    for (const description of functionCodes) {
      for (const direction of ['request', 'response'] as const) {
        // A reply that repeats its request says the same.
        if (description.request === description.response && direction === 'response') continue;
        for (const { field } of fieldsOf(description, direction, {})) {
          if (field.name !== 'padding') expect(inTable).toContain(`${description.code} ${direction} ${field.name}`);
        }
      }
    }
  });
});

describe('what is said of a byte of several', () => {
  const said = (pairs: string, name: string, index: number, transport: Transport = 'rtu') => {
    const bytes = hex(pairs);
    const span = decodeFrame(bytes, { transport, direction: 'request' }).spans.find((one) => one.name === name)!;
    return words.byteMeaning({ span, index, value: bytes[span.from + index]!, many: span.to - span.from });
  };

  it('is its share of a number, high byte first', () => {
    expect(said('11 03 01 6B 00 03 76 87', 'startAddress', 0)).toBe('High byte: 1 × 256 = 256.');
    expect(said('11 03 01 6B 00 03 76 87', 'startAddress', 1)).toBe('Low byte: 107.');
  });

  it('is the other way round in the CRC', () => {
    expect(said('11 03 00 6B 00 03 76 87', 'checksum', 0)).toBe('Low byte of the CRC, sent first.');
    expect(said('11 03 00 6B 00 03 76 87', 'checksum', 1)).toBe('High byte of the CRC.');
  });

  it('is a character in raw data, if it can be printed', () => {
    expect(said('11 41 50 01 00 00', 'data', 0)).toBe('As a character: P');
    expect(said('11 41 50 01 00 00', 'data', 1)).toBe('');
  });

  it('is carriage return or line feed at the end of an ASCII frame', () => {
    const ascii = '3A 31 31 30 33 30 30 36 42 30 30 30 33 37 45 0D 0A';
    expect(said(ascii, 'end', 0, 'ascii')).toBe('Carriage return.');
    expect(said(ascii, 'end', 1, 'ascii')).toBe('Line feed.');
  });
});
