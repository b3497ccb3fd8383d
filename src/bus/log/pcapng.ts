import { decodeFrame, encodeFrame, fromHex, toHex } from '../../modbus/index.ts';
import type { LogLine } from './line.ts';
import { numbered } from './log-files.ts';

/**
 * The capture format of Wireshark (pcapng, draft-ietf-opsawg-pcapng). Frames stand in it as "upper PDUs"
 * (LINKTYPE_WIRESHARK_UPPER_PDU), each with the name of the dissector that reads it, so that Wireshark decodes them without
 * any setting; and with ports, by which that dissector tells requests from replies.
 */
const LINK_TYPE = 252;
const DISSECTOR = 'mbrtu';
const SERVER_PORT = 502;
const CLIENT_PORT = 49_152;

const SECTION_HEADER = 0x0a0d0d0a;
const BYTE_ORDER_MAGIC = 0x1a2b3c4d;
const INTERFACE = 1;
const PACKET = 6;
const COMMENT = 1;
const TAG = { end: 0, dissector: 12, portType: 24, sourcePort: 25, destinationPort: 26 } as const;
const PORT_TYPE_UDP = 3;

/** The log as a capture. Wireshark knows no ASCII mode: such frames stand in it as the RTU frames that say the same. */
export function logAsPcapng(lines: readonly LogLine[]): Uint8Array<ArrayBuffer> {
  const blocks = [
    block(SECTION_HEADER, [u32(BYTE_ORDER_MAGIC), u16(1), u16(0), u32(0xffffffff), u32(0xffffffff)]),
    block(INTERFACE, [u16(LINK_TYPE), u16(0), u32(0)]),
    ...lines.map(packet),
  ];
  return joined(blocks);
}

function packet({ time, direction, kind, hex, transport }: LogLine): Uint8Array {
  const bytes = fromHex(hex) ?? new Uint8Array(0);
  const request = kind === 'request' || kind === 'echo' || (kind === 'heard' && direction === 'sent');
  const [source, destination] = request ? [CLIENT_PORT, SERVER_PORT] : [SERVER_PORT, CLIENT_PORT];
  const data = joined([
    tag(TAG.dissector, padded(new TextEncoder().encode(DISSECTOR))),
    tag(TAG.portType, big32(PORT_TYPE_UDP)),
    tag(TAG.sourcePort, big32(source)),
    tag(TAG.destinationPort, big32(destination)),
    tag(TAG.end, new Uint8Array(0)),
    transport === 'ascii' ? asRtu(bytes, request) : bytes,
  ]);
  const microseconds = BigInt(Math.round(time * 1000));
  const comment = new TextEncoder().encode(`${direction} ${kind}`);
  return block(PACKET, [
    u32(0),
    u32(Number(microseconds >> 32n)),
    u32(Number(microseconds & 0xffffffffn)),
    u32(data.length),
    u32(data.length),
    padded(data),
    u16(COMMENT),
    u16(comment.length),
    padded(comment),
    u32(0),
  ]);
}

function asRtu(bytes: Uint8Array, request: boolean): Uint8Array {
  const reading = decodeFrame(bytes, { transport: 'ascii', direction: request ? 'request' : 'response' });
  return reading.outcome.kind === 'whole' ? encodeFrame({ ...reading, transport: 'rtu' }) : bytes;
}

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

/** A block: its type, its length at both ends, and its body between them. */
function block(type: number, parts: readonly Uint8Array[]): Uint8Array {
  const length = u32(parts.reduce((sum, part) => sum + part.length, 12));
  return joined([u32(type), length, ...parts, length]);
}

/** A tag of an upper PDU; unlike the blocks around it, in network order. */
function tag(type: number, value: Uint8Array): Uint8Array {
  const head = new DataView(new ArrayBuffer(4));
  head.setUint16(0, type);
  head.setUint16(2, value.length);
  return joined([new Uint8Array(head.buffer), value]);
}

const u16 = (value: number) => new Uint8Array(Uint16Array.of(value).buffer);
const u32 = (value: number) => new Uint8Array(Uint32Array.of(value).buffer);
const big32 = (value: number) => u32(value).reverse();
const padded = (bytes: Uint8Array) => joined([bytes, new Uint8Array(-bytes.length & 3)]);

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
