// What goes over a serial line: requests and their replies, all functions mixed, and what loses and damages bytes of it.

/** Units on the line, and the share of requests that are refused. */
const UNITS = 247;
const REFUSED = 0.06;
/** The share of functions whose length no byte tells, which are not scored. */
const OPEN = 0.04;
const EXCEPTIONS = [1, 2, 3, 4, 5, 6, 8, 10, 11];

/**
 * A frame of the stream: its place, what it is, and whether it counts.
 * @typedef {{ from: number, to: number, direction: 'request' | 'response', functionCode: number, scored: boolean, pair: number }} Sent
 */

/**
 * Requests and replies one after another: of these functions, or of all, and then also some whose length no byte tells.
 * @param {import('./random.mjs').Random} random
 * @param {typeof import('../src/framewright.ts').encodeFrame} encodeFrame
 * @returns {{ bytes: Uint8Array, frames: Sent[] }}
 */
export function traffic(random, encodeFrame, pairs, codes = undefined) {
  const parts = [];
  const frames = [];
  let at = 0;
  for (let pair = 0; pair < pairs; pair++) {
    const unitId = 1 + below(random, UNITS);
    const { functionCode, request, response, open = false } = transaction(random, codes);
    const refused = chance(random, REFUSED);
    const exchange = [
      ['request', functionCode, request],
      refused
        ? ['response', functionCode + 0x80, { exceptionCode: pick(random, EXCEPTIONS) }]
        : ['response', functionCode, response],
    ];
    for (const [direction, code, fields] of exchange) {
      const frame = encodeFrame({ transport: 'rtu', direction, unitId, functionCode: code, fields });
      frames.push({
        from: at,
        to: at + frame.length,
        direction,
        functionCode: code,
        scored: !open || code !== functionCode,
        pair,
      });
      parts.push(frame);
      at += frame.length;
    }
  }
  return { bytes: Uint8Array.from(Buffer.concat(parts)), frames };
}

/**
 * The stream with bytes changed and left out, each with this probability, and where the frames are then that nothing
 * has happened to.
 */
export function damage(random, { bytes, frames }, changed, dropped) {
  const kept = [];
  const places = new Int32Array(bytes.length + 1);
  const harmed = new Int32Array(bytes.length + 1);
  for (let i = 0; i < bytes.length; i++) {
    places[i] = kept.length;
    harmed[i + 1] = harmed[i];
    if (chance(random, dropped)) harmed[i + 1]++;
    else if (chance(random, changed)) {
      harmed[i + 1]++;
      kept.push(bytes[i] ^ (1 + below(random, 255)));
    } else kept.push(bytes[i]);
  }
  places[bytes.length] = kept.length;
  return {
    bytes: Uint8Array.from(kept),
    frames: frames.map((frame) => ({
      ...frame,
      from: places[frame.from],
      to: places[frame.to],
      intact: harmed[frame.from] === harmed[frame.to],
    })),
  };
}

/** A whole number from 0, less than `limit`. */
const below = (random, limit) => random.next() % limit;
const chance = (random, share) => random.next() < share * 2 ** 24;
const pick = (random, list) => list[below(random, list.length)];
const word = (random) => random.next() & 0xffff;
/** Mostly few, as devices are asked; now and then as many as there can be. */
const some = (random, most) => 1 + below(random, chance(random, 0.5) ? Math.min(most, 20) : most);
const hex = (random, length) => Buffer.from(random.bytes(length)).toString('hex');
const bits = (random, length) => Array.from({ length }, () => random.next() & 1);
const placed = (random, quantity) => below(random, 0x10001 - quantity);
const many = (length, make) => Array.from({ length }, make);

const transactions = {
  1: (random) => readBits(random),
  2: (random) => readBits(random),
  3: (random) => readRegisters(random),
  4: (random) => readRegisters(random),
  5: (random) => echoed({ address: word(random), value: chance(random, 0.5) }),
  6: (random) => echoed({ address: word(random), value: word(random) }),
  7: (random) => ({ request: {}, response: { outputData: random.next() & 0xff } }),
  8: (random) => {
    const subFunction = pick(random, [0, 1, 2, 3, 10, 11, 12, 13, 14, 15, 16, 17, 18, 20]);
    const counter = subFunction === 2 || (subFunction >= 11 && subFunction <= 18);
    const data =
      { 0: hex(random, 2), 1: pick(random, ['0000', 'FF00']), 3: `${hex(random, 1)}00` }[subFunction] ?? '0000';
    return { request: { subFunction, data }, response: { subFunction, data: counter ? hex(random, 2) : data } };
  },
  11: (random) => ({ request: {}, response: { status: pick(random, [0, 0xffff]), eventCount: word(random) } }),
  12: (random) => ({
    request: {},
    response: {
      status: pick(random, [0, 0xffff]),
      eventCount: word(random),
      messageCount: word(random),
      events: [...random.bytes(below(random, 65))],
    },
  }),
  15: (random) => {
    const quantity = some(random, 1968);
    const startAddress = placed(random, quantity);
    return { request: { startAddress, bits: bits(random, quantity) }, response: { startAddress, quantity } };
  },
  16: (random) => {
    const quantity = some(random, 123);
    const startAddress = placed(random, quantity);
    return { request: { startAddress, registers: random.registers(quantity) }, response: { startAddress, quantity } };
  },
  17: (random) => ({ request: {}, response: { data: hex(random, some(random, 251)) } }),
  20: (random) => {
    const requests = many(1 + below(random, 4), () => ({ ...file(random), recordLength: some(random, 30) }));
    return {
      request: { subRequests: requests },
      response: {
        subResponses: requests.map(({ recordLength }) => ({
          referenceType: 6,
          recordData: random.registers(recordLength),
        })),
      },
    };
  },
  21: (random) =>
    echoed({
      subRequests: many(1 + below(random, 3), () => ({
        ...file(random),
        recordData: random.registers(some(random, 35)),
      })),
    }),
  22: (random) => echoed({ referenceAddress: word(random), andMask: word(random), orMask: word(random) }),
  23: (random) => {
    const readQuantity = some(random, 125);
    const written = some(random, 121);
    return {
      request: {
        readStartAddress: placed(random, readQuantity),
        readQuantity,
        writeStartAddress: placed(random, written),
        writeRegisters: random.registers(written),
      },
      response: { registers: random.registers(readQuantity) },
    };
  },
  24: (random) => ({
    request: { fifoPointerAddress: word(random) },
    response: { fifoValues: random.registers(below(random, 32)) },
  }),
  43: (random) => {
    const readDeviceIdCode = 1 + below(random, 4);
    const objectId = below(random, 7);
    return {
      request: { meiType: 14, readDeviceIdCode, objectId },
      response: {
        meiType: 14,
        readDeviceIdCode,
        conformityLevel: pick(random, [1, 2, 3, 0x81, 0x82, 0x83]),
        moreFollows: 0,
        nextObjectId: 0,
        objects: many(1 + below(random, 4), (_, i) => ({ objectId: i, valueHex: hex(random, below(random, 40)) })),
      },
    };
  },
};

const allCodes = Object.keys(transactions).map(Number);

/** A request and its reply, as fields. */
function transaction(random, codes) {
  if (codes === undefined && chance(random, OPEN)) return { ...openTransaction(random), open: true };
  const functionCode = pick(random, codes ?? allCodes);
  return { functionCode, ...transactions[functionCode](random) };
}

/** Functions whose length no byte tells. */
function openTransaction(random) {
  switch (below(random, 3)) {
    case 0: {
      const functionCode = chance(random, 0.5) ? 65 + below(random, 8) : 100 + below(random, 11);
      return {
        functionCode,
        request: { data: hex(random, some(random, 60)) },
        response: { data: hex(random, some(random, 60)) },
      };
    }
    case 1:
      return {
        functionCode: 43,
        request: { meiType: 13, meiData: hex(random, some(random, 60)) },
        response: { meiType: 13, meiData: hex(random, some(random, 60)) },
      };
    default:
      return { functionCode: 8, ...echoed({ subFunction: 0, data: hex(random, 2 * (2 + below(random, 20))) }) };
  }
}

const echoed = (fields) => ({ request: fields, response: fields });
const file = (random) => ({
  referenceType: 6,
  fileNumber: 1 + below(random, 0xffff),
  recordNumber: below(random, 10000),
});

function readBits(random) {
  const quantity = some(random, 2000);
  // Of the last byte, what was not asked for is zero.
  const values = bits(random, 8 * Math.ceil(quantity / 8)).fill(0, quantity);
  return { request: { startAddress: placed(random, quantity), quantity }, response: { bits: values } };
}

function readRegisters(random) {
  const quantity = some(random, 125);
  return {
    request: { startAddress: placed(random, quantity), quantity },
    response: { registers: random.registers(quantity) },
  };
}
