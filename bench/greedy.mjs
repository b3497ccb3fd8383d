// The plain version of `splitStream`: at each place, the first length that fits the function code and whose CRC holds; else the
// next place. It knows no direction where both fit, weighs no frames against each other, and looks at RTU only.
import { crc16 } from '../dist/lib/framewright.js';

/** Bytes of the PDU by function code, of requests and of replies; a function where a byte count tells. */
const counted = (at, before) => (bytes, from) => before + (bytes[from + at] ?? 0);
const fifo = (bytes, from) => 3 + (((bytes[from + 2] ?? 0) << 8) | (bytes[from + 3] ?? 0));
const REQUESTS = {
  1: 5,
  2: 5,
  3: 5,
  4: 5,
  5: 5,
  6: 5,
  7: 1,
  8: 5,
  11: 1,
  12: 1,
  15: counted(6, 6),
  16: counted(6, 6),
  17: 1,
  20: counted(2, 2),
  21: counted(2, 2),
  22: 7,
  23: counted(10, 10),
  24: 3,
  43: 4,
};
const REPLIES = {
  1: counted(2, 2),
  2: counted(2, 2),
  3: counted(2, 2),
  4: counted(2, 2),
  5: 5,
  6: 5,
  7: 2,
  8: 5,
  11: 5,
  12: counted(2, 2),
  15: 5,
  16: 5,
  17: counted(2, 2),
  20: counted(2, 2),
  21: counted(2, 2),
  22: 7,
  23: counted(2, 2),
  24: fifo,
};
const tableOf = (lengths) => Array.from({ length: 128 }, (_, code) => lengths[code]);
const SIDES = [tableOf(REQUESTS), tableOf(REPLIES)];
const MOST = 256;

/** The frames `[from, to)` of a stream, one behind the other. */
export function greedy(bytes) {
  const frames = [];
  for (let at = 0; at + 4 <= bytes.length; ) {
    const to = endAt(bytes, at);
    if (to === 0) at++;
    else {
      frames.push({ from: at, to });
      at = to;
    }
  }
  return frames;
}

function endAt(bytes, at) {
  const code = bytes[at + 1];
  if (code >= 128) return closes(bytes, at, at + 5);
  for (const lengths of SIDES) {
    const length = lengths[code];
    if (length === undefined) continue;
    const to = at + 1 + (typeof length === 'number' ? length : length(bytes, at)) + 2;
    if (to - at <= MOST && closes(bytes, at, to) > 0) return to;
  }
  return 0;
}

const closes = (bytes, at, to) =>
  to <= bytes.length && crc16(bytes, at, to - 2) === (bytes[to - 2] | (bytes[to - 1] << 8)) ? to : 0;
