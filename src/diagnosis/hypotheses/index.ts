import type { Hypothesis } from '../hypothesis.ts';
import { algorithm } from './checksum/algorithm.ts';
import { asciiChecksum } from './checksum/ascii.ts';
import { byteOrder } from './checksum/byte-order.ts';
import { flipped } from './checksum/flipped.ts';
import { lrcForCrc } from './checksum/lrc.ts';
import { misprint } from './checksum/misprint.ts';
import { missing } from './checksum/missing.ts';
import { otherFrame } from './checksum/other-frame.ts';
import { somethingElse } from './checksum/something-else.ts';
import { span } from './checksum/span.ts';
import { text } from './checksum/text.ts';
import { wrong } from './checksum/wrong.ts';
import { addresses } from './meaning/addresses.ts';
import { againstRequest } from './meaning/against-request.ts';
import { registers } from './meaning/registers.ts';
import { rule } from './meaning/rule.ts';
import { transports } from './meaning/transports.ts';
import { values } from './meaning/values.ts';
import { asciiLineEnd } from './shape/ascii-line-end.ts';
import { byteCount } from './shape/byte-count.ts';
import { echo } from './shape/echo.ts';
import { envelope } from './shape/envelope.ts';
import { extraBytes } from './shape/extra-bytes.ts';
import { fragments } from './shape/fragments.ts';
import { framesInside } from './shape/frames-inside.ts';
import { hexOfAscii } from './shape/hex-of-ascii.ts';
import { mbapLength } from './shape/mbap-length.ts';
import { noise } from './shape/noise.ts';
import { oneByte } from './shape/one-byte.ts';
import { otherProtocol } from './shape/other-protocol.ts';
import { rotated } from './shape/rotated.ts';
import { strayTruncated } from './shape/stray-truncated.ts';
import { truncated } from './shape/truncated.ts';
import { data } from './sound/data.ts';
import { valid } from './sound/valid.ts';

/** What is worth saying of a whole frame that breaks no rule. */
export const ofSoundFrames: readonly Hypothesis[] = [valid, addresses, registers];

/** What may have happened to bytes that are not the frame they should be. */
export const ofOthers: readonly Hypothesis[] = [
  misprint,
  byteOrder,
  text,
  algorithm,
  span,
  otherFrame,
  somethingElse,
  missing,
  lrcForCrc,
  flipped,
  wrong,
  asciiChecksum,
  echo,
  framesInside,
  strayTruncated,
  truncated,
  fragments,
  rotated,
  byteCount,
  extraBytes,
  oneByte,
  mbapLength,
  noise,
  otherProtocol,
  envelope,
  asciiLineEnd,
  hexOfAscii,
  againstRequest,
  values,
  transports,
  rule,
  data,
];
