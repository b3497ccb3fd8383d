import { describe, expect, it } from 'vitest';
import { type Draft, withForce, withoutGroup } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';

describe('a group that is removed', () => {
  /** Writes two registers of file 4 from record 7 on, and one of file 3 from record 9 on (AP 6.15). */
  const draft: Draft = {
    transport: 'pdu',
    kind: 'request',
    texts: {
      functionCode: '21',
      subRequests: '2',
      'subRequests[0].fileNumber': '4',
      'subRequests[0].recordNumber': '7',
      'subRequests[0].recordData': '0x06AF 0x04BE',
      'subRequests[1].fileNumber': '3',
      'subRequests[1].recordNumber': '9',
      'subRequests[1].recordData': '0x100D',
    },
    force: {},
    answering: '',
  };

  it('lets the groups after it move up', () => {
    expect(Array.from(evaluate(withoutGroup(draft, 'subRequests', 0, 2)).frame!.bytes)).toEqual([
      0x15, // function code
      0x09, // request data length
      0x06, // reference type
      0x00,
      0x03, // file number
      0x00,
      0x09, // record number
      0x00,
      0x01, // record length
      0x10,
      0x0d, // record data
    ]);
  });

  it('leaves the groups before it', () => {
    expect(Array.from(evaluate(withoutGroup(draft, 'subRequests', 1, 2)).frame!.bytes)).toEqual([
      0x15, 0x0b, 0x06, 0x00, 0x04, 0x00, 0x07, 0x00, 0x02, 0x06, 0xaf, 0x04, 0xbe,
    ]);
  });
});

it('a value is forced, and worked out again', () => {
  const draft: Draft = { transport: 'rtu', kind: 'request', texts: {}, force: { length: '9' }, answering: '' };
  expect(withForce(draft, 'checksum', '0').force).toEqual({ length: '9', checksum: '0' });
  expect(withForce(draft, 'length', undefined).force).toEqual({});
});

describe('the function that an exception refuses', () => {
  const refused = (functionCode: string) =>
    evaluate({
      transport: 'pdu',
      kind: 'exception',
      texts: { functionCode, exceptionCode: '1' },
      force: {},
      answering: '',
    });

  it('is at most 127: the top bit says that it was refused (AP 7)', () => {
    expect(Array.from(refused('127').frame!.bytes)).toEqual([0xff, 0x01]);
    for (const code of [128, 255]) {
      expect(refused(String(code)).errors.get('functionCode')).toEqual({
        code: 'number-out-of-range',
        got: code,
        least: 0,
        most: 127,
      });
    }
  });
});

it.each([
  [0, { 'a[0].x': 'one', 'a[1].x': 'two' }],
  [1, { 'a[0].x': 'zero', 'a[1].x': 'two' }],
  [2, { 'a[0].x': 'zero', 'a[1].x': 'one' }],
])('without group %i the others stay, and nothing of it is left', (index, groups) => {
  const texts = { unitId: '6', 'ab[2].x': 'other', a: '3', 'a[0].x': 'zero', 'a[1].x': 'one', 'a[2].x': 'two' };
  const typed = { 'a[2].x': { typed: 'II', text: 'two' } };
  const left = withoutGroup(
    { transport: 'pdu', kind: 'request', texts, force: {}, answering: '', typed, bytes: 'x' },
    'a',
    index,
    3,
  );
  expect(left.texts).toEqual({ unitId: '6', 'ab[2].x': 'other', a: '2', ...groups });
  expect(left.typed).toEqual(index === 2 ? {} : { 'a[1].x': typed['a[2].x'] });
  expect(left.bytes).toBeUndefined();
});
