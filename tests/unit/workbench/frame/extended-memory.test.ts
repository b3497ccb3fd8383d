import { describe, expect, it, test } from 'vitest';
import { fromHex } from '../../../../src/modbus/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { explain } from '../../../../src/workbench/frame/explanation.ts';
import { readLink, writeLink } from '../../../../src/workbench/frame/link.ts';
import { explanationWords } from './explanation-words.ts';

/** Two registers of file 3 from record 9 on, the second sub-request of the specification's example (AP 6.14). */
const read = (recordNumber: string) => {
  const { draft } = readLink(
    `#pdu/request?functionCode=20&subRequests=1&subRequests[0].fileNumber=3&subRequests[0].recordLength=2&subRequests[0].recordNumber=${recordNumber}`,
  )!;
  return { draft, ...evaluate(draft) };
};

const bytesOf = ({ frame }: ReturnType<typeof read>) => frame && Array.from(frame.bytes);
const RECORD_9 = [
  0x14, // function code
  0x07, // byte count
  0x06, // reference type
  0x00,
  0x03, // file number
  0x00,
  0x09, // record number
  0x00,
  0x02, // record length
];

describe('a record number', () => {
  test.each(['9', '0x0009', '6x9', '6x00009', '6:9', '600009'])('%s is record 9 of its file', (text) => {
    const reading = read(text);
    expect(bytesOf(reading)).toEqual(RECORD_9);
    expect(readLink(`#${writeLink(reading.draft, reading.controls)}`)!.draft.texts['subRequests[0].recordNumber']).toBe(
      text,
    );
  });

  it('is up to 9999; beyond it the frame is there, and wrong (AP 6.14)', () => {
    expect(read('609999').frame!.reading.problems).toEqual([]);
    expect(read('6x10000').frame!.reading.problems).toMatchObject([
      { code: 'value-out-of-range', got: 10000, least: 0, most: 9999 },
    ]);
  });

  it('that is not an address keeps its text', () => {
    expect(read('6y9').errors.get('subRequests[0].recordNumber')).toEqual({ code: 'not-an-address', text: '6y9' });
  });

  it('is explained with the number of extended memory', async () => {
    const { frame } = read('9');
    const lines = explain({ ...frame!, words: await explanationWords() });
    expect(lines.map(({ meaning }) => meaning)).toContain(
      'Address 9 (0x0009) = file record 600009 as extended memory.',
    );
  });
});

it('explains single coils with the numbers that manuals print (AP 6.1)', async () => {
  const { draft } = readLink('#pdu/reply?functionCode=1&bits=1 0 1 1 0 0 1 1 1 1&answering=010013000A')!;
  const { frame } = evaluate(draft);
  expect(frame!.bytes).toEqual(fromHex('01 02 CD 03'));
  const lines = explain({ ...frame!, words: await explanationWords() });
  expect(lines.map(({ meaning }) => meaning)).toContain('From the lowest bit, coil 27 (00028) ON, 28 (00029) ON.');
});
