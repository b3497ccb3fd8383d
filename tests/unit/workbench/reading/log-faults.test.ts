import { expect, it } from 'vitest';
import { chips, nextOfKind, readText } from '../../../../src/workbench/index.ts';

/** The faults of a text: the line of each, from 1, and what it is. */
const faultsOf = (text: string) => [...readText(text, undefined).faults.byIndex].map(([at, fault]) => [at + 1, fault]);

it('finds the exception, the requests without a reply and the wrong CRC of a log', () => {
  expect(faultsOf(chips.find(({ id }) => id === 'faulty-log')!.text)).toEqual([
    [6, { kind: 'exception', code: 2 }],
    [7, { kind: 'no-reply' }],
    [8, { kind: 'no-reply' }],
    [10, { kind: 'checksum' }],
  ]);
});

it('counts them by kind', () => {
  const { counts } = readText(chips.find(({ id }) => id === 'faulty-log')!.text, undefined).faults;
  expect(Object.fromEntries(counts)).toEqual({ exception: 1, 'no-reply': 2, checksum: 1 });
});

it('finds the exceptions and silences of every transport', () => {
  // MBAP headers and exceptions as TG 3.1.3 and AP 7 have them; unit 1, address 0.
  expect(
    faultsOf(
      [
        'Tx 00 01 00 00 00 06 01 03 00 00 00 01',
        'Rx 00 01 00 00 00 03 01 83 02',
        'Tx 00 02 00 00 00 06 01 03 00 00 00 01',
        'Tx 00 03 00 00 00 06 01 03 00 00 00 01',
        'Rx 00 03 00 00 00 05 01 03 02 00 07',
      ].join('\n'),
    ),
  ).toEqual([
    [2, { kind: 'exception', code: 2 }],
    [3, { kind: 'no-reply' }],
  ]);
});

it('expects no reply to a broadcast, to the last request, or in a text that has none', () => {
  const read = 'Tx 01 03 00 00 00 0A C5 CD';
  // Function 06 to unit 0.
  const broadcast = 'Tx 00 06 00 01 00 03 99 DA';
  expect(faultsOf(`${read}\n${read}\n${read}`)).toEqual([]);
  const answered = 'Tx 01 03 00 6B 00 02 B5 D7\nRx 01 03 04 02 2B 00 00 8B 83';
  expect(faultsOf(`${answered}\n${broadcast}\n${answered}\n${read}`)).toEqual([]);
  expect(faultsOf(`${answered}\n${read}\n${answered}`)).toEqual([[3, { kind: 'no-reply' }]]);
});

it('expects no reply in prose, which tells neither a time nor a side', () => {
  expect(
    faultsOf('01 03 00 6B 00 02 B5 D7\n01 03 04 02 2B 00 00 8B 83\n01 03 00 00 00 0A C5 CD\n01 03 00 6B 00 02 B5 D7'),
  ).toEqual([]);
});

it('names bytes in no frame', () => {
  const [fault] = faultsOf('Tx 01 03 00 6B 00 02 B5 D7\nRx 01 03 04 02 2B 00 00 8B 83\nRx 5A').slice(-1);
  expect(fault).toEqual([3, { kind: 'no-frame' }]);
});

it('leads from fault to fault of a kind, and from the last to the first', () => {
  const { faults } = readText(chips.find(({ id }) => id === 'faulty-log')!.text, undefined);
  expect([0, 6, 7].map((from) => nextOfKind(faults, 'no-reply', from))).toEqual([6, 7, 6]);
  expect(nextOfKind(faults, 'checksum', 0)).toBe(9);
  expect(nextOfKind(faults, 'no-frame', 0)).toBe(-1);
});
