import { describe, expect, test } from 'vitest';
import type { FrameInput, Values } from '../../../src/modbus/index.ts';
import { hex } from '../modbus/frames.ts';
import { Planned } from './planned.ts';

const asked = (functionCode: number, fields: Values): FrameInput => ({
  transport: 'tcp',
  direction: 'request',
  unitId: 1,
  transactionId: 0,
  functionCode,
  fields,
});
const header = '00 00 00 00 00';
/** A reply with its header. */
const reply = (pdu: string) => {
  const bytes = hex(pdu);
  return Uint8Array.of(...hex(`${header} ${(bytes.length + 1).toString(16).padStart(2, '0')} 01`), ...bytes);
};

describe('the records of AP 6.14', () => {
  const planned = new Planned(
    asked(0x14, {
      subRequests: [
        { referenceType: 6, fileNumber: 4, recordNumber: 1, recordLength: 2 },
        { referenceType: 6, fileNumber: 3, recordNumber: 9, recordLength: 2 },
      ],
    }),
  );

  test('are taken out, those of all groups one after another', () => {
    expect(planned.checked(reply('14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40'))).toEqual({
      result: 0,
      list: [0x0dfe, 0x0020, 0x33cd, 0x0040],
    });
  });

  test.each([
    ['of another length each, but the same in all', '14 0C 03 06 0D FE 07 06 00 20 33 CD 00 40'],
    ['of another length in all', '14 0A 05 06 0D FE 00 20 03 06 33 CD'],
    ['with half a register', '14 0C 04 06 0D FE 00 06 06 33 CD 00 40 00'],
    ['that go beyond the reply', '14 0C 05 06 0D FE 00 20 09 06 33 CD 00 40'],
  ])('%s are refused', (_, pdu) => {
    expect(planned.checked(reply(pdu)).result).toBe(-5);
  });
});

describe('one object of AP 6.21', () => {
  const planned = new Planned(asked(0x2b, { meiType: 14, readDeviceIdCode: 4, objectId: 2 }));

  test('is given as its bytes', () => {
    const { result, list } = planned.checked(reply('2B 0E 04 01 00 00 01 02 02 41 42'));
    expect([result, list?.slice(0, 4)]).toEqual([0, [2, 2, 0x41, 0x42]]);
  });

  test.each([
    ['another object', '2B 0E 04 01 00 00 01 01 02 41 42', -6],
    ['two objects', '2B 0E 04 01 00 00 02 02 01 41 02 01 42', -6],
    ['no object', '2B 0E 04 01 00 00 00', -6],
    ['an object that is cut off', '2B 0E 04 01 00 00 01 02 03 41 42', -5],
    ['a lower level, as any device may answer', '2B 0E 01 01 00 00 01 00 02 41 42', 0],
  ])('%s', (_, pdu, result) => {
    expect(planned.checked(reply(pdu)).result).toBe(result);
  });
});
