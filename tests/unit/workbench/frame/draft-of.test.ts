import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { decodeFrame, fromHex } from '../../../../src/modbus/index.ts';
import { draftOf } from '../../../../src/workbench/frame/draft-of-reading.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink, writeLink } from '../../../../src/workbench/frame/link.ts';
import { anyDirection, anyTransport } from '../../modbus/arbitraries.ts';
import { brokenFrames, frames } from '../../modbus/vectors.ts';

const bytesOf = (text: string) => fromHex(text.replaceAll(' ', ''))!;
const rtu = (text: string, direction: 'request' | 'response' = 'request', request?: Uint8Array) =>
  draftOf(decodeFrame(bytesOf(text), { transport: 'rtu', direction, request }), request);

const comesBack = (bytes: Uint8Array, context: Parameters<typeof decodeFrame>[1]) => {
  const draft = draftOf(decodeFrame(bytes, context), context.request);
  const { errors, frame, controls } = evaluate(draft);
  expect(errors).toEqual(new Map());
  expect(Array.from(frame!.bytes)).toEqual(Array.from(bytes));
  const linked = readLink(`#${writeLink(draft, controls)}`)!;
  expect(linked.unknown).toEqual([]);
  expect(Array.from(evaluate(linked.draft).frame!.bytes)).toEqual(Array.from(bytes));
};

describe('the draft of bytes', () => {
  test('types a frame into the form as a person would', () => {
    expect(rtu('06 06 02 AB 10 00 F5 E5')).toEqual({
      transport: 'rtu',
      kind: 'request',
      texts: { unitId: '6', functionCode: '6', address: '0x02AB', value: '4096' },
      force: {},
      answering: '',
    });
  });

  test('keeps a wrong checksum, a wrong byte count, what is cut off and what is left over', () => {
    expect(rtu('06 06 02 AB 10 00 E6 A1').force).toEqual({ checksum: '0xA1E6' });
    expect(rtu('01 03 00 6B 00').force).toEqual({ quantity: '[00]', checksum: '[]' });
    expect(rtu('01 03 00 6B 00 03 74 17 00').force).toEqual({ after: '00' });
    expect(rtu('').force).toEqual({ unitId: '[]', functionCode: '[]', checksum: '[]' });
  });

  test('is an exception where the function code says so, and knows the request', () => {
    const draft = rtu('01 83 02 C0 F1', 'response', bytesOf('01 03 00 00 00 04 44 09'));
    expect(draft).toMatchObject({ kind: 'exception', texts: { functionCode: '3', exceptionCode: '2' } });
    expect(draft.answering).toBe('01 03 00 00 00 04 44 09');
  });

  test('gives every known frame, sound or broken, back through the form and through the link', () => {
    for (const { hex, transport, direction, request } of frames) {
      const answered = request === undefined ? undefined : bytesOf(request);
      comesBack(bytesOf(hex), { transport, direction, request: answered });
    }
    for (const { hex, transport, directions } of brokenFrames) {
      for (const direction of directions) {
        comesBack(bytesOf(hex), { transport, direction });
      }
    }
  });

  test('gives any bytes back', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 300 }), anyTransport, anyDirection, (bytes, transport, direction) => {
        comesBack(bytes, { transport, direction });
      }),
      { numRuns: 700 },
    );
  });
});
