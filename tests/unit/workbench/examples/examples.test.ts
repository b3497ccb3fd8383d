import { describe, expect, it } from 'vitest';
import { misprintedFrames } from '../../../../src/diagnosis/index.ts';
import { toHex } from '../../../../src/modbus/index.ts';
import { examples as words } from '../../../../src/words/en/examples.ts';
import { exampleSources } from '../../../../src/workbench/examples/examples.ts';
import { comparePrinted } from '../../../../src/workbench/examples/printed.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { bitwiseCrc } from '../../modbus/reference.ts';

/** The bytes of every example, as they are to be sent. */
const RIGHT = {
  'weg-set-30-hz': '06 06 02 AB 10 00 F5 E5',
  'weg-run': '06 06 02 AA 00 01 68 25',
  'weg-stop': '06 06 02 AA 00 00 A9 E5',
  'weg-read-speed': '06 03 02 A9 00 01 54 25',
  'weg-speed': '06 03 02 10 00 00 44',
  's7-200-read': '01 03 00 00 00 05 85 C9',
  's7-200-write': '01 10 00 05 00 02 04 00 01 00 02 E3 91',
  'i-8xx7-read-bits': '01 01 10 20 00 0F 79 04',
  'i-8xx7-bits': '01 01 02 00 12 39 F1',
  'i-8xx7-write-bit': '01 05 00 06 FF 00 6C 3B',
  'i-8xx7-bit-written': '01 05 00 06 FF 00 6C 3B',
  'i-8xx7-write-words': '01 10 21 00 00 02 04 12 34 56 78 1C CA',
  'i-8xx7-words-written': '01 10 21 00 00 02 4B F4',
  'i-8xx7-tcp-read-word': '01 02 00 00 00 06 09 03 00 04 00 01',
  'i-8xx7-tcp-word': '01 02 00 00 00 05 09 03 02 00 08',
  'i-8xx7-tcp-read-bits': '03 29 00 00 00 06 07 01 00 02 00 08',
  'i-8xx7-tcp-bits': '03 29 00 00 00 04 07 01 01 49',
  'introduction-read-40108': '11 03 00 6B 00 03 76 87',
  'introduction-40108': '11 03 06 02 2B 00 00 00 64 C8 BA',
  'introduction-read-401000': '21 03 03 E7 00 04 F3 1A',
  'introduction-401000': '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18',
};

/** What the sources print otherwise than it is right. */
const PRINTED_WRONG = {
  'weg-set-30-hz': '06 06 02 AB 10 00 E6 A1',
  'weg-run': '06 06 02 AA 00 01 F5 27',
  'weg-stop': '06 06 02 AA 00 00 26 35',
  'weg-read-speed': '06 03 02 A9 00 01 D5 E7',
  'introduction-read-40108': '11 03 00 0B 00 03',
};

const octets = (text: string) => text.split(' ').map((pair) => Number.parseInt(pair, 16));
const hex = (text: string) => text.replaceAll(' ', '');
const examples = exampleSources.flatMap((source) => source.examples);
const byId = new Map(examples.map((example) => [example.id as string, example]));

describe('every example', () => {
  it('is one of those with literal bytes here, once, with its words', () => {
    expect(examples.map(({ id }) => id)).toEqual(Object.keys(RIGHT));
    expect(Object.keys(words.names)).toEqual(Object.keys(RIGHT));
    expect(exampleSources.map(({ id }) => id)).toEqual(Object.keys(words.sources));
  });

  for (const [id, right] of Object.entries(RIGHT)) {
    it(`${id} is ${right}`, () => {
      const { draft } = byId.get(id)!;
      const { frame, errors } = evaluate(draft);
      expect([...errors]).toEqual([]);
      expect(toHex(frame!.bytes)).toBe(hex(right));
      expect(frame!.reading.problems.filter(({ severity }) => severity !== 'note')).toEqual([]);
      const bytes = octets(right);
      if (draft.transport === 'rtu') {
        const crc = bitwiseCrc(bytes.slice(0, -2));
        expect(bytes.slice(-2)).toEqual([crc & 0xff, crc >> 8]);
      } else {
        expect(bytes.slice(2, 6)).toEqual([0, 0, 0, bytes.length - 6]);
      }
    });
  }
});

describe('what the sources print', () => {
  for (const [id, printed] of Object.entries(PRINTED_WRONG)) {
    it(`${id}: ${printed} is wrong`, () => {
      const example = byId.get(id)!;
      expect(example.printed).toBe(printed);
      expect(example.fault).toBe(id.startsWith('weg') ? 'crc' : 'address');
      expect(comparePrinted(example).wrongAt).toEqual(id.startsWith('weg') ? [6, 7] : [3]);
    });
  }

  it('is wrong where the diagnosis knows of it, and corrected as there', () => {
    expect(misprintedFrames.map(({ id }) => id)).toEqual(Object.keys(PRINTED_WRONG));
    for (const { id, right } of misprintedFrames) expect(toHex(right), id).toBe(hex(RIGHT[id]));
  });

  it('is the beginning of what is right in all others', () => {
    for (const example of examples.filter(({ id }) => !(id in PRINTED_WRONG))) {
      const { right, printed, wrongAt } = comparePrinted(example);
      expect(example.fault, example.id).toBeUndefined();
      expect(wrongAt, example.id).toEqual([]);
      expect(toHex(right).startsWith(toHex(printed)), example.id).toBe(true);
    }
  });

  it('leaves bytes out only here', () => {
    const lacking = examples.filter(
      (example) => comparePrinted(example).printed.length < comparePrinted(example).right.length,
    );
    expect(lacking.map(({ id }) => id)).toEqual([
      'weg-speed',
      's7-200-read',
      's7-200-write',
      'introduction-read-40108',
      'introduction-40108',
    ]);
  });

  it('falls into runs of right and of wrong bytes', () => {
    const runs = ({ runs }: ReturnType<typeof comparePrinted>) => runs.map(({ bytes, wrong }) => [toHex(bytes), wrong]);
    expect(runs(comparePrinted(byId.get('weg-run')!))).toEqual([
      ['060602AA0001', false],
      ['F527', true],
    ]);
    expect(runs(comparePrinted(byId.get('introduction-read-40108')!))).toEqual([
      ['110300', false],
      ['0B', true],
      ['0003', false],
    ]);
  });

  it('goes astray at the first shift of the 30 Hz frame', () => {
    // 0xFFFF with the first byte 06 is 0xFFF9; its lowest bit is 1.
    expect((0xfff9 >> 1) ^ 0xa001).toBe(0xdffd);
    expect(words.more['weg-set-30-hz']).toContain('0xDFFD, not 0xD7FC');
  });
});

describe('replies', () => {
  const replies = examples.filter(({ draft }) => draft.kind === 'reply');

  it('carry the request that they answer, which is the example before', () => {
    for (const reply of replies) {
      const before = examples[examples.indexOf(reply) - 1]!;
      expect(hex(reply.draft.answering), reply.id).toBe(hex(RIGHT[before.id]));
    }
    expect(replies.map(({ id }) => id)).toEqual([
      'weg-speed',
      'i-8xx7-bits',
      'i-8xx7-bit-written',
      'i-8xx7-words-written',
      'i-8xx7-tcp-word',
      'i-8xx7-tcp-bits',
      'introduction-40108',
      'introduction-401000',
    ]);
  });

  it('hold what their sources say they hold', () => {
    const fields = (id: string) => evaluate(byId.get(id)!.draft).frame!.reading.fields;
    expect(fields('weg-speed')).toMatchObject({ registers: [4096] });
    expect(fields('i-8xx7-bits')).toMatchObject({ bits: [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0] });
    expect(fields('i-8xx7-tcp-word')).toMatchObject({ registers: [8] });
    expect(fields('introduction-40108')).toMatchObject({ registers: [555, 0, 100] });
    expect(fields('introduction-401000')).toMatchObject({ registers: [12345, 54321, 6666, 8888] });
  });
});
