import { expect, test } from 'vitest';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { runsOf } from '../../../../src/workbench/values/runs.ts';

const runs = (link: string) => {
  const { reading, bytes } = evaluate(readLink(link)!.draft).frame!;
  return runsOf(reading, bytes);
};

test('registers have their bytes, and their address as far as the frame or its request says it', () => {
  // 11 03 02 02 2B, the reply to a read of 1 register from 107.
  expect(runs('#rtu/reply?unitId=17&functionCode=3&registers=555&answering=11+03+00+6B+00+01+F7+16')).toEqual([
    [{ value: 555, from: 3, to: 5, address: 107 }],
  ]);
  expect(runs('#rtu/reply?unitId=17&functionCode=3&registers=555+1')).toEqual([
    [
      { value: 555, from: 3, to: 5, address: undefined },
      { value: 1, from: 5, to: 7, address: undefined },
    ],
  ]);
  // Each character of ASCII is a byte.
  expect(runs('#ascii/request?functionCode=6&address=9&value=3')).toEqual([
    [{ value: 3, from: 9, to: 13, address: 9 }],
  ]);
});

test('records of a file have their file and number, from the request in a reply (AP 6.14)', () => {
  const asked = '140E0600040001000206000300090002';
  const groups = 'subResponses=2&subResponses[0].recordData=0x0DFE+0x0020&subResponses[1].recordData=0x33CD+0x0040';
  const records = (link: string) => runs(link).map((run) => run.map(({ value, record }) => [value, record]));
  expect(records(`#pdu/reply?functionCode=20&${groups}&answering=${asked}`)).toEqual([
    [
      [0x0dfe, { file: 4, record: 1 }],
      [0x0020, { file: 4, record: 2 }],
    ],
    [
      [0x33cd, { file: 3, record: 9 }],
      [0x0040, { file: 3, record: 10 }],
    ],
  ]);
  // 14 0C | 05 06 0DFE 0020 | 05 06 33CD 0040
  const places = runs(`#pdu/reply?functionCode=20&${groups}`).map((run) => run.map(({ from, to }) => [from, to]));
  expect(places).toEqual([
    [
      [4, 6],
      [6, 8],
    ],
    [
      [10, 12],
      [12, 14],
    ],
  ]);
  expect(records(`#pdu/reply?functionCode=20&${groups}`)[0]).toEqual([
    [0x0dfe, undefined],
    [0x0020, undefined],
  ]);
});

test('function 17 has registers at its own addresses in each direction', () => {
  const addresses = (link: string) => runs(link).map((run) => run.map(({ address }) => address));
  expect(
    addresses('#pdu/request?functionCode=23&readStartAddress=3&writeStartAddress=14&writeRegisters=255+256'),
  ).toEqual([[14, 15]]);
  expect(addresses('#pdu/reply?functionCode=23&registers=254+2765&answering=1700030002000E00010200FF')).toEqual([
    [3, 4],
  ]);
  expect(addresses('#pdu/reply?functionCode=24&fifoValues=0x01B8+0x1284')).toEqual([[undefined, undefined]]);
  expect(addresses('#pdu/request?functionCode=5&address=1&value=1')).toEqual([]);
});
