import fc, { type Arbitrary } from 'fast-check';
import {
  type Direction,
  describeFunction,
  type Field,
  type FrameInput,
  fieldsOf,
  functionCodes,
  type Range,
  type Transport,
  type Values,
} from '../../../src/modbus/index.ts';

export const transports = ['rtu', 'ascii', 'tcp', 'pdu'] as const;
export const directions = ['request', 'response'] as const;

export const anyTransport: Arbitrary<Transport> = fc.constantFrom(...transports);
export const anyDirection: Arbitrary<Direction> = fc.constantFrom(...directions);

const u8 = fc.nat(0xff);
const u16 = fc.nat(0xffff);
const hexOf = (range: { minLength?: number; maxLength: number }) =>
  fc.uint8Array(range).map((bytes) => Buffer.from(bytes).toString('hex').toUpperCase());

/** The field of a function's own description, wherever in its layout it stands. */
function fieldOf(code: number, direction: Direction, name: string, chosen: Values = {}): Field {
  for (const { field } of fieldsOf(describeFunction(code, direction), direction, chosen)) {
    const inner = [field, ...(field.group ?? [])].find((candidate) => candidate.name === name);
    if (inner !== undefined) return inner;
  }
  throw new Error(`${code} ${direction} has no field ${name}`);
}

function rangeOf(code: number, direction: Direction, name: string, chosen?: Values): Range {
  const { range } = fieldOf(code, direction, name, chosen);
  if (range === undefined) throw new Error(`${code} ${direction}: ${name} has no range`);
  return range;
}

const allowedOf = (code: number, direction: Direction, name: string, chosen?: Values) =>
  fc.constantFrom(...(fieldOf(code, direction, name, chosen).allowed ?? []));

/** A legal number of elements, now and then the least or the most of them. */
const numberIn = ({ least, most }: Range) =>
  fc.oneof({ weight: 3, arbitrary: fc.integer({ min: least, max: most }) }, fc.constantFrom(least, most));

/** So many elements from an address that leaves room for all of them. */
const placed = (range: Range): Arbitrary<readonly [address: number, number: number]> =>
  numberIn(range).chain((number) => fc.tuple(fc.nat(0x10000 - number), fc.constant(number)));

const words = (number: number) => fc.array(u16, { minLength: number, maxLength: number });
const bits = (number: number) => fc.array(fc.constantFrom(0, 1), { minLength: number, maxLength: number });

const asked = (code: number) =>
  placed(rangeOf(code, 'request', 'quantity')).map(([startAddress, quantity]) => ({ startAddress, quantity }));
const written = (code: number) =>
  placed(rangeOf(code, 'response', 'quantity')).map(([startAddress, quantity]) => ({ startAddress, quantity }));
const readBits = (code: number) =>
  numberIn(rangeOf(code, 'response', 'byteCount'))
    .chain((bytes) => bits(8 * bytes))
    .map((values) => ({ bits: values }));
const readWords = (code: number) =>
  numberIn(rangeOf(code, 'response', 'byteCount'))
    .chain((bytes) => words(bytes >> 1))
    .map((registers) => ({ registers }));

const coil = fc.record({ address: u16, value: fc.boolean() });
const register = fc.record({ address: u16, value: u16 });
const mask = fc.record({ referenceAddress: u16, andMask: u16, orMask: u16 });
const nothing = fc.constant({});

const data = (...pairs: string[]) => fc.constantFrom(...pairs);
const word = hexOf({ minLength: 2, maxLength: 2 });
const anyWords = fc.array(word, { minLength: 1, maxLength: 125 }).map((each) => each.join(''));
const diagnostics = (subFunction: Arbitrary<number>, carried: Arbitrary<string>) =>
  fc.record({ subFunction, data: carried });
/** The sub-functions of AP 6.8.1 that ask with 0000. */
const zeroSubFunctions = [2, 4, 10, 11, 12, 13, 14, 15, 16, 17, 18, 20];
const delimiter = hexOf({ minLength: 1, maxLength: 1 }).map((character) => `${character}00`);

const fileNumber = numberIn(rangeOf(0x14, 'request', 'fileNumber'));
const recordNumber = numberIn(rangeOf(0x14, 'request', 'recordNumber'));
const file = { referenceType: fc.constant(6), fileNumber, recordNumber };
/** A reply has two bytes a group and two a register; its 253 bytes hold 251 of them. */
const fitsReply = (groups: readonly { readonly recordLength: number }[]) =>
  groups.reduce((sum, { recordLength }) => sum + 2 + 2 * recordLength, 0) <= 251;
const fileRequests = fc
  .array(fc.record({ ...file, recordLength: fc.integer({ min: 1, max: 124 }) }), { minLength: 1, maxLength: 35 })
  .map((groups) => groups.filter((_, i) => fitsReply(groups.slice(0, i + 1))));
const fileAnswers = fc
  .array(fc.record({ referenceType: fc.constant(6), recordData: fc.array(u16, { minLength: 1, maxLength: 124 }) }), {
    minLength: 1,
    maxLength: 35,
  })
  .map((groups) =>
    groups.filter((_, i) =>
      fitsReply(groups.slice(0, i + 1).map(({ recordData }) => ({ recordLength: recordData.length }))),
    ),
  );
const fileWrites = fc
  .array(fc.record({ ...file, recordData: fc.array(u16, { minLength: 1, maxLength: 122 }) }), {
    minLength: 1,
    maxLength: 27,
  })
  .map((groups) =>
    groups.filter(
      (_, i) => groups.slice(0, i + 1).reduce((sum, { recordData }) => sum + 7 + 2 * recordData.length, 0) <= 251,
    ),
  );

const IDENTIFICATION = { meiType: 14 };
const objectId = fc.oneof(fc.integer({ min: 0, max: 6 }), fc.integer({ min: 0x80, max: 0xff }));
const idCode = allowedOf(0x2b, 'request', 'readDeviceIdCode', IDENTIFICATION);
const identification = fc
  .record({
    meiType: fc.constant(14),
    readDeviceIdCode: idCode,
    conformityLevel: allowedOf(0x2b, 'response', 'conformityLevel', IDENTIFICATION),
    more: fc.option(u8),
    objects: fc.array(fc.record({ objectId, valueHex: hexOf({ maxLength: 244 }) }), { minLength: 1, maxLength: 12 }),
  })
  .map(({ more, objects, ...header }) => ({
    ...header,
    moreFollows: more === null ? 0 : 0xff,
    nextObjectId: more ?? 0,
    // 253 bytes less the seven before the objects, and two before each value.
    objects: objects.filter(
      (_, i) => objects.slice(0, i + 1).reduce((sum, { valueHex }) => sum + 2 + valueHex.length / 2, 0) <= 246,
    ),
  }));
const canopen = fc.record({ meiType: fc.constant(13), meiData: hexOf({ maxLength: 251 }) });

type Legal = Arbitrary<Values>;

/** The legal inputs of every function, in both directions. */
export const legalFields: Readonly<Record<number, Readonly<Record<Direction, Legal>>>> = {
  1: { request: asked(0x01), response: readBits(0x01) },
  2: { request: asked(0x02), response: readBits(0x02) },
  3: { request: asked(0x03), response: readWords(0x03) },
  4: { request: asked(0x04), response: readWords(0x04) },
  5: { request: coil, response: coil },
  6: { request: register, response: register },
  7: { request: nothing, response: fc.record({ outputData: u8 }) },
  8: {
    request: fc.oneof(
      diagnostics(fc.constant(0), anyWords),
      diagnostics(fc.constant(1), data('0000', 'FF00')),
      diagnostics(fc.constant(3), delimiter),
      diagnostics(fc.constantFrom(...zeroSubFunctions), data('0000')),
    ),
    // 04 is never answered.
    response: fc.oneof(
      diagnostics(fc.constant(0), anyWords),
      diagnostics(fc.constant(1), data('0000', 'FF00')),
      diagnostics(fc.constantFrom(...zeroSubFunctions.filter((sub) => sub !== 4)), word),
    ),
  },
  11: { request: nothing, response: fc.record({ status: allowedOf(0x0b, 'response', 'status'), eventCount: u16 }) },
  12: {
    request: nothing,
    response: fc.record({
      status: allowedOf(0x0c, 'response', 'status'),
      eventCount: u16,
      messageCount: u16,
      events: numberIn(rangeOf(0x0c, 'response', 'byteCount')).chain((bytes) =>
        fc.array(u8, { minLength: bytes - 6, maxLength: bytes - 6 }),
      ),
    }),
  },
  15: {
    request: placed(rangeOf(0x0f, 'request', 'quantity')).chain(([startAddress, number]) =>
      bits(number).map((values) => ({ startAddress, bits: values })),
    ),
    response: written(0x0f),
  },
  16: {
    request: placed(rangeOf(0x10, 'request', 'quantity')).chain(([startAddress, number]) =>
      words(number).map((registers) => ({ startAddress, registers })),
    ),
    response: written(0x10),
  },
  17: {
    request: nothing,
    response: numberIn(rangeOf(0x11, 'response', 'byteCount'))
      .chain((bytes) => hexOf({ minLength: bytes, maxLength: bytes }))
      .map((id) => ({ data: id })),
  },
  20: {
    request: fileRequests.map((subRequests) => ({ subRequests })),
    response: fileAnswers.map((subResponses) => ({ subResponses })),
  },
  21: {
    request: fileWrites.map((subRequests) => ({ subRequests })),
    response: fileWrites.map((subRequests) => ({ subRequests })),
  },
  22: { request: mask, response: mask },
  23: {
    request: fc
      .tuple(placed(rangeOf(0x17, 'request', 'readQuantity')), placed(rangeOf(0x17, 'request', 'writeQuantity')))
      .chain(([[readStartAddress, readQuantity], [writeStartAddress, number]]) =>
        words(number).map((writeRegisters) => ({ readStartAddress, readQuantity, writeStartAddress, writeRegisters })),
      ),
    response: readWords(0x17),
  },
  24: {
    request: fc.record({ fifoPointerAddress: u16 }),
    response: numberIn(rangeOf(0x18, 'response', 'fifoCount'))
      .chain(words)
      .map((fifoValues) => ({ fifoValues })),
  },
  43: {
    request: fc.oneof(canopen, fc.record({ meiType: fc.constant(14), readDeviceIdCode: idCode, objectId })),
    response: fc.oneof(canopen, identification),
  },
};

const refusal = fc.record({ exceptionCode: allowedOf(0x81, 'response', 'exceptionCode') });

/** A legal frame of any function, an exception among its replies, in this transport and direction. */
export function legalFrame(code: number, transport: Transport, direction: Direction): Arbitrary<FrameInput> {
  const said: Arbitrary<{ functionCode: number; fields: Values }> =
    direction === 'request'
      ? (legalFields[code] as Record<Direction, Legal>).request.map((fields) => ({ functionCode: code, fields }))
      : fc.oneof(
          {
            weight: 4,
            arbitrary: (legalFields[code] as Record<Direction, Legal>).response.map((fields) => ({
              functionCode: code,
              fields,
            })),
          },
          refusal.map((fields) => ({ functionCode: code + 0x80, fields })),
        );
  const envelope = fc.record({
    transport: fc.constant(transport),
    direction: fc.constant(direction),
    ...(transport === 'pdu' ? {} : { unitId: fc.integer({ min: 1, max: 247 }) }),
    ...(transport === 'tcp' ? { transactionId: u16 } : {}),
  });
  return fc.tuple(envelope, said).map(([around, inside]) => ({ ...around, ...inside }));
}

export const anyLegalFrame: Arbitrary<FrameInput> = fc
  .tuple(fc.constantFrom(...functionCodes.map(({ code }) => code)), anyTransport, anyDirection)
  .chain(([code, transport, direction]) => legalFrame(code, transport, direction));

/** Bytes of all kinds: any at all, small ones that look like codes and counts, characters, and frames gone wrong. */
export const anyCharacters = fc
  .array(fc.constantFrom(...'0123456789ABCDEFabcdef::\r\n x'), { maxLength: 60 })
  .map((each) => Uint8Array.from(each, (character) => character.charCodeAt(0)));
const smallBytes = fc.array(fc.oneof(fc.nat(24), u8), { maxLength: 40 }).map((bytes) => Uint8Array.from(bytes));
export const anyBytes: Arbitrary<Uint8Array> = fc.oneof(fc.uint8Array({ maxLength: 300 }), smallBytes, anyCharacters);
