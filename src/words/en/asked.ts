import type { AskedChecksum, AskedTiming } from '../../workbench/index.ts';
import { byteHex, bytesOf, fields, views, word } from './common.ts';
import { exceptionName } from './sent.ts';

/** A time of a line, in microseconds. */
const inMilliseconds = (time: number): string => `${(time / 1000).toFixed(3)} ms`;

/** What is answered where a text asks for something that is not a frame. */
export const asked = {
  checksum: ({ size, crc, lrc }: AskedChecksum): string => {
    if (size === 0) return 'Type the bytes behind it, such as “crc 02 07”.';
    const values = [
      ...(crc === undefined ? [] : [`CRC ${word(crc)}, sent as ${byteHex(crc & 0xff)} ${byteHex(crc >> 8)}`]),
      ...(lrc === undefined ? [] : [`LRC 0x${byteHex(lrc)}`]),
    ];
    return values.length === 0
      ? 'Modbus has no such checksum; the Checksum view finds it by its name or by a value.'
      : `Over ${bytesOf(size)}: ${values.join('; ')}.`;
  },
  timing: ({ line, character, t15, t35, wrong }: AskedTiming): string =>
    wrong === undefined
      ? `At ${views.lineName(line)} a character takes ${inMilliseconds(character)}; t1.5 is ${inMilliseconds(t15)}, t3.5 is ${inMilliseconds(t35)}.`
      : `${wrong} is not one of a line: 50 to 4,000,000 baud, 7 or 8 data bits, parity none, even or odd, 1 or 2 stop bits, such as 9600 8N1.`,
  exception: (code: number): string => {
    const hint = fields.choices['exceptionCode']?.[code]?.hint;
    const name = exceptionName(code);
    return `${name.charAt(0).toUpperCase()}${name.slice(1)}${hint ? `: ${hint}` : ' is not in the specification'}.`;
  },
  /** The code as it is looked for. */
  codeText: (code: number) => `0x${byteHex(code)}`,
  open: {
    checksum: 'Open in the Checksum view',
    timing: 'Open in the Timing view',
    exception: 'Open in the Reference',
  },
  /** Below the answer. */
  stays: 'The frame stays as it is.',
};
