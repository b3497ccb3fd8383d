// Requests and their replies as they go over a serial line, of the functions most devices have and of some that few have.
import { encodeFrame } from '../../dist/lib/framewright.js';

const READS = [
  [0x03, 'registers', 125],
  [0x04, 'registers', 125],
  [0x01, 'bits', 2000],
  [0x02, 'bits', 2000],
];
const EXCEPTIONS = [1, 2, 3, 4, 6, 8, 10, 11];

/** A request and its reply: `{ request, reply }` of what `encodeFrame` takes, without unit identifier and transport. */
export function conversation(random) {
  const say = pick(random, [reads, reads, reads, writeOne, writeOne, writeMany, writeMany, rare, refused]);
  const said = say(random);
  return { unitId: 1 + below(random, 247), ...said };
}

/** Both frames' bytes in a transport. */
export function frames({ unitId, request, reply }, transport, transactionId = 0) {
  const encode = (direction, { functionCode, fields }) =>
    encodeFrame({ transport, direction, unitId, transactionId, functionCode, fields });
  return { request: encode('request', request), reply: encode('response', reply) };
}

export const below = (random, limit) => random.next() % limit;
export const pick = (random, list) => list[below(random, list.length)];

/** As often one of a few as any number: traffic is made of both. */
const amount = (random, most) => 1 + below(random, random.next() & 1 ? Math.min(most, 12) : most);
const word = (random) => (random.next() & 1 ? random.next() & 0xffff : random.next() & 0x3ff);
const address = (random, quantity) => (random.next() & 1 ? below(random, 0x10000 - quantity) : below(random, 2000));

function reads(random) {
  const [functionCode, name, most] = pick(random, READS);
  const quantity = amount(random, most);
  const values =
    name === 'bits'
      ? Array.from({ length: quantity }, () => random.next() & 1)
      : Array.from({ length: quantity }, () => word(random));
  const padded = name === 'bits' ? values.concat(new Array((8 - (quantity % 8)) % 8).fill(0)) : values;
  return {
    request: { functionCode, fields: { startAddress: address(random, quantity), quantity } },
    reply: { functionCode, fields: { [name]: padded } },
  };
}

function writeOne(random) {
  const coil = random.next() & 1;
  const fields = { address: address(random, 1), value: coil ? (random.next() & 1) === 1 : word(random) };
  const said = { functionCode: coil ? 0x05 : 0x06, fields };
  return { request: said, reply: said };
}

function writeMany(random) {
  const coils = random.next() & 1;
  const quantity = amount(random, coils ? 1968 : 123);
  const startAddress = address(random, quantity);
  const list = Array.from({ length: quantity }, () => (coils ? random.next() & 1 : word(random)));
  const functionCode = coils ? 0x0f : 0x10;
  return {
    request: { functionCode, fields: { startAddress, [coils ? 'bits' : 'registers']: list } },
    reply: { functionCode, fields: { startAddress, quantity } },
  };
}

function rare(random) {
  const masks = { referenceAddress: word(random), andMask: word(random), orMask: word(random) };
  const list = Array.from({ length: amount(random, 31) }, () => word(random));
  return pick(random, [
    { request: { functionCode: 0x16, fields: masks }, reply: { functionCode: 0x16, fields: masks } },
    {
      request: { functionCode: 0x18, fields: { fifoPointerAddress: word(random) } },
      reply: { functionCode: 0x18, fields: { fifoValues: list } },
    },
    {
      request: { functionCode: 0x0b, fields: {} },
      reply: { functionCode: 0x0b, fields: { status: 0, eventCount: word(random) } },
    },
    {
      request: {
        functionCode: 0x17,
        fields: { readStartAddress: 10, readQuantity: list.length, writeStartAddress: 20, writeRegisters: list },
      },
      reply: { functionCode: 0x17, fields: { registers: list } },
    },
  ]);
}

function refused(random) {
  const { request } = pick(random, [reads, writeOne, writeMany])(random);
  const fields = { exceptionCode: pick(random, EXCEPTIONS) };
  return { request, reply: { functionCode: request.functionCode | 0x80, fields } };
}
