import { crc16, lrc } from '../../modbus/index.ts';
import { readBytes } from '../../notation/index.ts';
import { isTextNote } from './read-text.ts';

/** A checksum over bytes, as a text asks for it. */
export interface AskedChecksum {
  readonly tool: 'checksum';
  /** How many bytes there are; 0 if the text names none. */
  readonly size: number;
  /** Those of Modbus that are asked for; of any other the Checksum view alone has the value. */
  readonly crc?: number;
  readonly lrc?: number;
  /** What the Checksum view is to show. */
  readonly parts: Readonly<Record<string, string>>;
}

/** Names of the checksums of Modbus (SL 2.5.1.2, SL 2.5.2.2). */
const CRC = /^(?:modbus)?(?:crc(?:16)?(?:modbus)?|fcs|checksums?)$/;
const LRC = /^(?:modbus)?(?:lrc8?(?:modbus)?|checksums?)$/;
/** Other algorithms have their width in their names, or are sums; `crc error` is neither. */
const OTHER = /^(?:(?:crc|lrc|fletcher|adler)\d[a-z\d]*|(?:sum|xor|bcc)\d*)$/;
const FILLERS = /^(?:what|what's|is|the|a|of|for|over|from|calculate|compute|calc|get|find|please|rtu|ascii|bytes?)$/i;
const BYTES = /^(?:0x|\\x|16#|\$)?(?:[\da-f]{2})+h?$|^\d{1,3}$/i;

/** Reads `crc 02 07`, `01 03 00 00 00 0A checksum`, `lrc of 0x11 0x03`, `crc-32 31 32`. */
export function checksumAsked(typed: string): AskedChecksum | undefined {
  const words = typed.split(/[\s,;:=()]+/).filter((word) => word !== '');
  const first = words.findIndex((word) => BYTES.test(word));
  const end = words.findLastIndex((word) => BYTES.test(word)) + 1;
  const data = first < 0 ? [] : words.slice(first, end);
  if (!data.every((word) => BYTES.test(word))) return undefined;
  const named = first < 0 ? words : [...words.slice(0, first), ...words.slice(end)];
  const written = named.filter((word) => !FILLERS.test(word)).join('');
  const name = written.toLowerCase().replace(/[^a-z\d]/g, '');
  const [isCrc, isLrc] = [CRC.test(name), LRC.test(name)];
  if (!isCrc && !isLrc && !OTHER.test(name)) return undefined;
  if (data.length === 0) return isCrc || isLrc ? { tool: 'checksum', size: 0, parts: {} } : undefined;
  const text = data.join(' ');
  const { bytes, problems } = readBytes(text);
  if (bytes.length === 0 || !problems.every(isTextNote)) return undefined;
  return {
    tool: 'checksum',
    size: bytes.length,
    ...(isCrc && { crc: crc16(bytes) }),
    ...(isLrc && { lrc: lrc(bytes) }),
    parts: {
      bytes: text,
      algorithm: isLrc && !isCrc ? 'LRC' : '',
      // Catalogues write a hyphen before the width.
      search: isCrc || isLrc ? '' : name.replace(/^([a-z]+)(?=\d)/, '$1-'),
    },
  };
}
