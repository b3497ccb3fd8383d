import { describe, expect, test } from 'vitest';
import { fromHex } from '../../../../src/modbus/index.ts';
import { formatBytes } from '../../../../src/notation/index.ts';
import { type Draft, evaluate, firstDraft, typedByte, withByte } from '../../../../src/workbench/index.ts';

const frameOf = (draft: Draft) => evaluate(draft).frame!;
const shown = (draft: Draft) => formatBytes(frameOf(draft).bytes);
const edited = (draft: Draft, at: number, value: number) => withByte(draft, frameOf(draft), at, value);

describe('a byte of the frame is changed in place', () => {
  test('a byte of the value: the checksum is calculated again', () => {
    const next = edited(firstDraft, 4, 0x08);
    // 06 06 02 AB 08 00: CRC-16 0xE5FF.
    expect(shown(next)).toBe('06 06 02 AB 08 00 FF E5');
    expect(next.texts).toEqual({ unitId: '6', functionCode: '6', address: '0x02AB', value: '2048' });
    expect(next.force).toEqual({});
  });

  test('a byte of the checksum: the frame has it as typed', () => {
    const next = edited(firstDraft, 6, 0xe6);
    expect(shown(next)).toBe('06 06 02 AB 10 00 E6 E5');
    expect(next.force).toEqual({ checksum: '0xE5E6' });
    // A checksum that was typed stays while other bytes change.
    expect(shown(edited(next, 5, 0x01))).toBe('06 06 02 AB 10 01 E6 E5');
  });

  test('what was typed for the other fields stays', () => {
    const draft: Draft = {
      ...firstDraft,
      typed: { address: { typed: 'P0683', text: '0x02AB' } },
      texts: { ...firstDraft.texts, address: '0x02AB', unitId: '0x06' },
      device: 'weg',
    };
    const next = edited(draft, 5, 0x01);
    expect(next.texts['unitId']).toBe('0x06');
    expect(next.typed).toEqual(draft.typed);
    expect(next.device).toBe('weg');
  });

  test('the same value changes nothing', () => {
    expect(edited(firstDraft, 0, 6)).toBe(firstDraft);
  });

  test('in a reply the request stays that it answers', () => {
    const reply: Draft = {
      transport: 'rtu',
      kind: 'reply',
      texts: { unitId: '17', functionCode: '1', bits: '1 0 1' },
      force: {},
      answering: '11 01 00 13 00 03 8E 9E',
    };
    const next = edited(reply, 3, 0x02);
    expect(next.answering).toBe(reply.answering);
    expect(frameOf(next).bytes.subarray(0, 4)).toEqual(fromHex('11010102'));
  });
});

test('a typed byte is one or two digits; in ASCII also a character', () => {
  expect(typedByte('a1', 'rtu')).toBe(0xa1);
  expect(typedByte('7', 'tcp')).toBe(7);
  expect(typedByte('7', 'ascii')).toBe(0x37);
  expect(typedByte('0D', 'ascii')).toBe(0x0d);
  for (const text of ['', 'G', '1G', '123', ' 1']) expect(typedByte(text, 'rtu')).toBeUndefined();
});
