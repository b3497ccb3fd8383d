// The ways in which frames are damaged, each with the finding that should come first.
import { crc, crc16, crcCatalogue, lrc, toHex } from '../../dist/lib/framewright.js';
import { below, frames, pick } from './conversations.mjs';
import { atSpeed, inverted, withParityBit } from './line.mjs';

const join = (...parts) => Uint8Array.from(parts.flatMap((part) => Array.from(part)));
const body = (frame) => frame.subarray(0, -2);
const low = (value) => [value & 0xff, value >>> 8];
const high = (value) => [value >>> 8, value & 0xff];
const withCrc = (bytes) => join(bytes, low(crc16(bytes)));
const characters = (text) => Uint8Array.from(text, (one) => one.charCodeAt(0));
const changed = (bytes, at, value) => bytes.map((byte, i) => (i === at ? value : byte));
const cut = (bytes, missing) => bytes.slice(0, bytes.length - missing);
const WORDS = crcCatalogue.filter(({ width, name }) => width === 16 && name !== 'CRC-16/MODBUS');
const SHORT = 14;
const junk = (random, length) => random.bytes(length);
const STYLES = [
  (hex) => hex.match(/../g).join(' '),
  (hex) => hex,
  (hex) => hex.toLowerCase().match(/../g).join(' '),
  (hex) =>
    hex
      .match(/../g)
      .map((pair) => `0x${pair}`)
      .join(', '),
  (hex) => hex.match(/../g).join(','),
];

/** A way: `make(frame, random, pair)` answers the bytes, or `undefined` where the frame cannot be damaged so. */
const way = (name, finding, make, options = {}) => ({ name, finding, make, needs: 'either', ...options });

const checksum = [
  way('nothing', ['valid', 'valid-exception'], (frame) => frame),
  way('CRC bytes swapped', 'crc-byte-order', (frame) => join(body(frame), high(crc16(body(frame))))),
  way('CRC of the text', 'crc-of-text', (frame, random) =>
    join(body(frame), low(crc16(characters(pick(random, STYLES)(toHex(body(frame))))))),
  ),
  way('CRC of another algorithm', ['crc-algorithm', 'crc-start-value'], (frame, random) =>
    join(body(frame), pick(random, [low, high])(crc(pick(random, WORDS), body(frame)))),
  ),
  way('CRC without the unit', 'crc-span', (frame) => join(body(frame), low(crc16(frame, 1, frame.length - 2)))),
  way('CRC over its own zeros', 'crc-span', (frame) => join(body(frame), low(crc16(join(body(frame), [0, 0]))))),
  way('CRC of the request', 'crc-of-other-frame', (frame, _, { request }) => join(body(frame), request.slice(-2)), {
    needs: 'distinct',
  }),
  way('CRC left out', 'crc-missing', (frame) => body(frame)),
  way('CRC zero', 'crc-missing', (frame) => join(body(frame), [0, 0])),
  way('LRC for CRC', 'lrc-instead-of-crc', (frame) => join(body(frame), [lrc(body(frame))])),
  way('CR LF for CRC', 'crc-is-something-else', (frame) => join(body(frame), [0x0d, 0x0a])),
  way('any CRC', 'crc-wrong', (frame, random) => join(body(frame), random.bytes(2))),
  way('one bit', 'bit-error', (frame, random) => {
    const at = below(random, frame.length);
    return changed(frame, at, frame[at] ^ (1 << below(random, 8)));
  }),
  way('one byte of up to 14', ['byte-error', 'bit-error'], (frame, random) => {
    const at = below(random, frame.length);
    return frame.length > SHORT ? undefined : changed(frame, at, frame[at] ^ (1 + below(random, 255)));
  }),
];

const shape = [
  way('echo', 'echo', (_, __, { request }) => request, { needs: 'distinct' }),
  way('echo cut off', 'truncated-echo', (_, random, { request }) => cut(request, 1 + below(random, 2)), {
    needs: 'distinct',
  }),
  way('1 to 3 bytes in front', 'stray-leading', (frame, random) => join(junk(random, 1 + below(random, 3)), frame)),
  way('1 to 3 bytes behind', 'stray-trailing', (frame, random) => join(frame, junk(random, 1 + below(random, 3)))),
  way('zeros behind', 'stray-trailing', (frame) => join(frame, [0])),
  way('bytes around', 'stray-around', (frame, random) => join(junk(random, 1), frame, junk(random, 1))),
  way('one in front, the end lost', 'stray-leading+truncated', (frame, random) => cut(join(junk(random, 1), frame), 1)),
  way('cut off', 'truncated', (frame, random) => {
    const missing = 1 + below(random, frame.length - 2);
    return missing === 2 ? undefined : cut(frame, missing);
  }),
  way('two frames', 'merged', (_, __, { request, reply }) => join(request, reply), { needs: 'none' }),
  way('rotated', 'rotated', (frame, random) => {
    const by = 1 + below(random, frame.length - 1);
    return join(frame.slice(-by), frame.slice(0, -by));
  }),
  way('byte count left out', 'byte-count', (frame) => withCrc(join(frame.slice(0, 2), frame.slice(3, -2))), {
    only: 'read reply',
  }),
  way(
    'byte count wrong',
    'byte-count',
    (frame, random) => withCrc(changed(body(frame), 2, frame[2] ^ (1 + below(random, 255)))),
    {
      only: 'read reply',
    },
  ),
  way('bytes too many inside', ['extra-bytes', 'byte-count'], (frame, random) =>
    withCrc(join(body(frame), random.bytes(2))),
  ),
  way('read at twice the speed', 'noise', (frame) => atSpeed(frame, 2)),
  way('read at half the speed', 'noise', (frame) => atSpeed(frame, 0.5)),
  way('read at 3/4 of the speed', 'noise', (frame) => atSpeed(frame, 0.75)),
  way('wires swapped', 'noise', (frame) => inverted(frame)),
  way('parity taken for data', 'noise', (frame) => withParityBit(frame), { transport: 'ascii' }),
  way('random bytes', 'noise', (frame, random) => random.bytes(frame.length)),
];

const meaning = [
  way('another unit answers', 'unit-mismatch', (frame) => withCrc(changed(body(frame), 0, (frame[0] % 247) + 1)), {
    needs: 'reply',
  }),
  way('refusal of another function', 'exception-of-other-function', (frame) => withCrc([frame[0], 0x91, 0x02]), {
    needs: 'reply',
  }),
  way('coil 1 written as 0001', 'coil-value-illegal', (frame) => withCrc(join(frame.slice(0, 4), [0, 1])), {
    only: 'coil request',
  }),
  way('MBAP on a serial line', 'mbap-on-serial', (frame) => frame, { transport: 'tcp', told: 'rtu' }),
  way('RTU on an MBAP port', 'rtu-on-tcp', (frame) => frame, { told: 'tcp' }),
  way('MBAP length off by one', 'mbap-length', (frame, random) => changed(frame, 5, frame[5] + pick(random, [-1, 1])), {
    transport: 'tcp',
  }),
  way('transaction swapped', 'transaction-swapped', (frame) => join([frame[1], frame[0]], frame.slice(2)), {
    transport: 'tcp',
    needs: 'reply',
  }),
  way('ASCII without LF', 'ascii-line-end', (frame) => cut(frame, 1), { transport: 'ascii' }),
  way('CRC for LRC', 'crc-instead-of-lrc', (_, __, { rtu }) => characters(`:${toHex(rtu)}\r\n`), {
    transport: 'ascii',
  }),
  way('ASCII on an RTU line', 'hex-of-ascii-frame', (frame) => frame, { transport: 'ascii', told: 'rtu' }),
];

export const ways = [...checksum, ...shape, ...meaning];

/** Findings that no way makes yet: most depend on what a person took for what, or on the frames before. */
export const withoutWay = [
  'valid-data',
  'byte-inserted',
  'byte-lost',
  'known-misprint',
  'lrc-wrong',
  'lrc-missing',
  'fragments',
  'other-protocol',
  'envelope',
  'function-mismatch',
  'broadcast-answered',
  'padding-bits',
  'quantity-mismatch',
  'quantity-in-32-bit',
  'register-bytes-swapped',
  'address-is-number',
  'address-off-by-one',
  'function-of-other-table',
  'rtu-on-ascii',
  'crc-on-tcp',
  'transaction-mismatch',
  'rule-broken',
];

/** One case of a way: `{ bytes, context }`, or `undefined` where this conversation gives none. */
export function caseOf({ make, needs, only, transport = 'rtu', told = transport }, said, random, known) {
  const transactionId = random.next() & 0xffff;
  const pair = frames(said, transport, transactionId);
  const isReply =
    needs === 'reply' ||
    needs === 'distinct' ||
    only === 'read reply' ||
    (only !== 'coil request' && needs === 'either' && (known || random.next() & 1));
  const { functionCode } = isReply ? said.reply : said.request;
  if (only === 'read reply' && ![1, 2, 3, 4, 0x17].includes(functionCode)) return undefined;
  if (only === 'coil request' && functionCode !== 5) return undefined;
  if (needs === 'distinct' && [5, 6, 0x16].includes(said.request.functionCode)) return undefined;
  const frame = isReply ? pair.reply : pair.request;
  const rtu = frames(said, 'rtu')[isReply ? 'reply' : 'request'];
  const bytes = make(frame, random, { ...pair, rtu });
  const asked = needs === 'reply' || needs === 'distinct' || (known && needs === 'either');
  return bytes && { bytes, context: { transport: told, ...(asked && { request: pair.request }) } };
}
