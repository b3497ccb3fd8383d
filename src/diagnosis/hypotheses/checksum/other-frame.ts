import { crc16, describeFunction, encodeFrame, exceptionCodes, FrameError, fieldsOf } from '../../../modbus/index.ts';
import { type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import type { FindingData } from '../../finding.ts';
import { word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { isOwnReply } from '../../request.ts';
import { aboutCrc, explainedBits } from './explained.ts';

type Of = FindingData['crc-of-other-frame']['of'];

interface Other {
  readonly of: Of;
  readonly value: number;
}

/** The replies to these repeat the first six bytes of the request. */
const SHORT_REPLY = 6;

/** The CRC belongs to another frame: one of the same conversation, or this one before its list was changed. */
export const otherFrame: Hypothesis = {
  codes: ['crc-of-other-frame'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) =>
      [framesNear(item, wrong), versionsOf(wrong)].flatMap((frames) =>
        frames
          .filter(({ value }) => value === wrong.got)
          .slice(0, 1)
          .map(({ of }) => ({
            code: 'crc-of-other-frame' as const,
            ...aboutCrc(item, wrong),
            of,
            bits: explainedBits(wrong, frames.length),
          })),
      ),
    ),
};

function framesNear({ bytes, request }: Case, wrong: WrongCrc): Other[] {
  const { unitId, direction, reading, end } = wrong;
  if (direction === 'response') {
    // If the reply repeats the request, its checksum is right, and something else is wrong.
    const distinct = request?.reading.transport === 'rtu' && !isOwnReply(request);
    const asked = distinct ? request.reading.checksum : undefined;
    return asked === undefined ? [] : [{ of: 'request', value: asked }];
  }
  const functionCode = reading.functionCode ?? 0;
  const refusals = exceptionCodes.map(({ code }) => ({
    of: 'exception' as const,
    value: crc16(Uint8Array.of(unitId, functionCode | 0x80, code)),
  }));
  const repeated = end > SHORT_REPLY ? [{ of: 'reply' as const, value: crc16(bytes, 0, SHORT_REPLY) }] : [];
  return [...refusals, ...repeated, ...repliesTo(bytes, wrong)];
}

/** Replies with values that people use in examples: zeros, ones, and the words of the request. */
function repliesTo(bytes: Uint8Array, { unitId, reading, end }: WrongCrc): Other[] {
  const { functionCode = 0, fields } = reading;
  const quantity = fields['quantity'] ?? fields['readQuantity'];
  const list = listOf(functionCode, 'response', fields);
  if (list === undefined || typeof quantity !== 'number') return [];
  const words = list.kind === 'registers' ? [word(bytes, 2), word(bytes, end - 2)] : [];
  return [...new Set([0, 1, ...words])].flatMap((value) => {
    const items = new Array<number>(quantity).fill(value);
    const crc = crcOf({ direction: 'response', unitId, functionCode, fields: { ...fields, [list.name]: items } });
    return crc === undefined ? [] : [{ of: 'reply' as const, value: crc }];
  });
}

/** How many values more or fewer are tried. */
const CHANGED = [1, 2, 3, 4, 5, 6, 7, 8];

/** The same frame with fewer values, or with zeros added, and the counts for them. */
function versionsOf({ unitId, direction, reading }: WrongCrc): Other[] {
  const { functionCode = 0, fields } = reading;
  const list = listOf(functionCode, direction, fields);
  const items = list && fields[list.name];
  if (list === undefined || !Array.isArray(items)) return [];
  const step = list.kind === 'bits' ? 8 : 1;
  const version = (of: Of, changed: readonly unknown[]): Other[] => {
    const value = crcOf({ direction, unitId, functionCode, fields: { ...fields, [list.name]: changed } });
    return value === undefined ? [] : [{ of, value }];
  };
  return CHANGED.flatMap((by) => [
    ...(by * step < items.length ? version('shorter', items.slice(0, -by * step)) : []),
    ...version('longer', [...items, ...new Array<number>(by * step).fill(0)]),
  ]);
}

/** The list of registers or bits that a frame of this function carries. */
function listOf(functionCode: number, direction: 'request' | 'response', fields: Readonly<Record<string, unknown>>) {
  for (const { field } of fieldsOf(describeFunction(functionCode, direction), direction, fields)) {
    if (field.kind === 'registers' || field.kind === 'bits') return field;
  }
  return undefined;
}

/** The CRC of a frame; `undefined` if its values have no bytes. */
function crcOf(input: Omit<Parameters<typeof encodeFrame>[0], 'transport'>): number | undefined {
  try {
    const frame = encodeFrame({ ...input, transport: 'rtu' });
    return crc16(frame, 0, frame.length - 2);
  } catch (error) {
    if (error instanceof FrameError) return undefined;
    throw error;
  }
}
