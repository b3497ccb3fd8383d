// What is measured: each subject with its inputs, their right answers, and by how much we mean to be the faster one.
import { readReply, readRequest, referenceCrc16, writeRequest } from './frames.mjs';
import { Random } from './random.mjs';

/**
 * @typedef {object} Case
 * @property {any} input what a peer is given, after its own `prepare`
 * @property {any} answer a CRC, a frame, or registers
 *
 * @typedef {object} Subject
 * @property {string} id
 * @property {string} title
 * @property {string} measure the name under which a peer exports its way of doing this
 * @property {'checksum' | 'frame' | 'registers'} answers
 * @property {string} unit
 * @property {number} perInput how many of the unit one input is
 * @property {number} target our speed divided by that of the fastest peer, at least
 * @property {() => Case[]} cases
 */

/** Inputs change from call to call, so that no compiler can work out an answer once and for all. */
const VARIANTS = 64;
const UNIT_ID = 17;
const START_ADDRESS = 107;

/** @type {Subject[]} */
export const subjects = [
  crc('crc-8', '8 bytes', 8, VARIANTS, 1.5),
  crc('crc-256', '256 bytes', 256, VARIANTS, 3),
  // Fewer of these: 64 MiB would measure the memory, and take long to make.
  crc('crc-1m', '1 MiB', 2 ** 20, 2, 3.5),
  {
    id: 'encode-03',
    title: 'Encoding an RTU request, 03 (3 registers)',
    measure: 'encode03',
    answers: 'frame',
    unit: 'frames/s',
    perInput: 1,
    target: 1.5,
    cases: () =>
      variants((i) => {
        const input = { unitId: UNIT_ID, startAddress: START_ADDRESS + i, quantity: 3 };
        return { input, answer: readRequest(input) };
      }),
  },
  {
    id: 'encode-10',
    title: 'Encoding an RTU request, 10 (100 registers)',
    measure: 'encode10',
    answers: 'frame',
    unit: 'frames/s',
    perInput: 1,
    target: 3,
    cases: () =>
      variants((i, random) => {
        const input = { unitId: UNIT_ID, startAddress: START_ADDRESS + i, registers: random.registers(100) };
        return { input, answer: writeRequest(input) };
      }),
  },
  decode('decode-10', 'decode10', 10),
  decode('decode-100', 'decode100', 100),
];

/** @returns {Subject} */
function crc(id, size, length, count, target) {
  return {
    id,
    title: `CRC-16 of ${size}`,
    measure: 'crc16',
    answers: 'checksum',
    unit: 'MB/s',
    perInput: length / 1e6,
    target,
    cases: () =>
      variants((_, random) => {
        const input = random.bytes(length);
        return { input, answer: referenceCrc16(input) };
      }, count),
  };
}

/** @returns {Subject} */
function decode(id, measure, quantity) {
  return {
    id,
    title: `Decoding an RTU reply, 03 (${quantity} registers)`,
    measure,
    answers: 'registers',
    unit: 'frames/s',
    perInput: 1,
    target: 3,
    cases: () =>
      variants((_, random) => {
        const answer = random.registers(quantity);
        return { input: readReply({ unitId: UNIT_ID, registers: answer }), answer };
      }),
  };
}

function variants(make, count = VARIANTS) {
  const random = new Random();
  return Array.from({ length: count }, (_, i) => make(i, random));
}
