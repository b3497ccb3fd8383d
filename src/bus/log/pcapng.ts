import { writePcapng } from '../../captures/index.ts';
import { fromHex, toHex } from '../../modbus/index.ts';
import type { LogLine } from './line.ts';
import { numbered } from './log-files.ts';

const SECTION_HEADER = 0x0a0d0d0a;
const BYTE_ORDER_MAGIC = 0x1a2b3c4d;
const PACKET = 6;
const DISSECTOR = 'mbrtu';
const SERVER_PORT = 502;
const TAG = { end: 0, dissector: 12, destinationPort: 26 } as const;

/** The log as a capture for Wireshark. */
export const logAsPcapng = (lines: readonly LogLine[]): Uint8Array<ArrayBuffer> =>
  writePcapng(
    lines.map(({ time, direction, kind, hex, transport }) => ({
      bytes: fromHex(hex) ?? new Uint8Array(0),
      transport,
      side:
        kind === 'request' || kind === 'echo' || (kind === 'heard' && direction === 'sent') ? 'request' : 'response',
      time: time * 1000,
      comment: `${direction} ${kind}`,
    })),
  );

/** The RTU frames of a capture that this page wrote; `undefined` if it is not a capture or has other packets. */
export function logFromPcapng(bytes: Uint8Array): LogLine[] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 12 || view.getUint32(0, true) !== SECTION_HEADER) return undefined;
  const little = view.getUint32(8, true) === BYTE_ORDER_MAGIC;
  const lines: LogLine[] = [];
  for (let at = 0; at + 12 <= bytes.length; ) {
    const length = view.getUint32(at + 4, little);
    if (length < 12 || length % 4 !== 0 || at + length > bytes.length) break;
    if (view.getUint32(at, little) === PACKET && length >= 32) {
      const line = lineOf(new DataView(bytes.buffer, bytes.byteOffset + at + 8, length - 12), little);
      if (line) lines.push(line);
    }
    at += length;
  }
  return lines.length > 0 ? numbered(lines) : undefined;
}

function lineOf(body: DataView, little: boolean): LogLine | undefined {
  const size = body.getUint32(12, little);
  const end = 20 + size;
  if (end > body.byteLength) return undefined;
  let dissector = '';
  let destination = 0;
  let at = 20;
  for (let type = -1; type !== TAG.end; ) {
    if (at + 4 > end) return undefined;
    type = body.getUint16(at);
    const length = body.getUint16(at + 2);
    const value = at + 4;
    at = value + length;
    if (at > end) return undefined;
    if (type === TAG.dissector) dissector = textOf(body, value, length);
    if (type === TAG.destinationPort && length === 4) destination = body.getUint32(value);
  }
  if (dissector !== DISSECTOR || at === end) return undefined;
  const request = destination === SERVER_PORT;
  const time = Number((BigInt(body.getUint32(4, little)) << 32n) | BigInt(body.getUint32(8, little))) / 1000;
  return {
    number: 0,
    time,
    direction: request ? 'sent' : 'received',
    transport: 'rtu',
    kind: request ? 'request' : 'heard',
    hex: toHex(new Uint8Array(body.buffer, body.byteOffset + at, end - at)),
  };
}

const textOf = (view: DataView, from: number, length: number) =>
  new TextDecoder().decode(new Uint8Array(view.buffer, view.byteOffset + from, length)).replaceAll('\0', '');
