import type { FormatStanding, GapEffect, ReceiveError, SerialMode } from '../../modbus/index.ts';
import type { LevelKind, ReceiverKind, Reception } from '../../workbench/index.ts';
import { bytesOf } from './common.ts';

/** Digits behind the point, without zeros at the end. */
const digits = (value: number, decimals: number) => String(Number(value.toFixed(decimals))).replace(/^-/, '−');

/** A time in microseconds, with as many digits as matter: `859.4 µs`, `4.583 ms`, `1.2 s`. */
function time(micros: number): string {
  const size = Math.abs(micros);
  if (size < 1000) return `${digits(micros, size < 10 ? 3 : 1)} µs`;
  return size < 1_000_000 ? `${digits(micros / 1000, 3)} ms` : `${digits(micros / 1_000_000, 3)} s`;
}

/** A time at a mark of a scale whose marks are `step` apart, all in the same unit. */
function mark(micros: number, step: number): string {
  if (step < 100) return `${digits(micros, 2)} µs`;
  return step < 100_000 ? `${digits(micros / 1000, 4)} ms` : `${digits(micros / 1_000_000, 4)} s`;
}

const gapEffects: Readonly<Record<GapEffect, string>> = {
  whole: 'no longer than t1.5: the frame stays whole',
  discarded: 'longer than t1.5: a receiver may discard the frame',
  'two-frames': 't3.5 or longer: a receiver takes it for two frames, and both fail',
};

const standings: Readonly<Record<FormatStanding, (mode: SerialMode) => string>> = {
  default: (mode) => `The default of ${mode === 'rtu' ? 'RTU' : 'ASCII'}.`,
  named: () => 'Named in the specification beside the default.',
  common: () => 'Common, but not in the specification: without parity it has two stop bits.',
  unusual: () => 'Not in the specification.',
  impossible: () => 'Seven data bits cannot carry RTU: the highest bit of every byte is lost.',
};

const errors: Readonly<Record<ReceiveError, string>> = {
  parity: 'parity wrong',
  framing: 'no stop bit',
  break: 'no stop bit, nothing but zeros (break)',
};

function reception({ sent, received, wrong, same }: Reception): string {
  if (received === 0) return 'It reads nothing at all.';
  if (same) return 'It reads the same bytes, all without an error.';
  const counts = `${bytesOf(sent)} sent, ${received} read, ${wrong} of them with an error.`;
  if (wrong > 0) return `${counts} A receiver discards such a frame, and a device does not answer it.`;
  return `${counts} They are other bytes than those sent: the checksum will not hold.`;
}

/** The frame on its line. */
export const wire = {
  time,
  mark,
  gapEffects,
  standing: (standing: FormatStanding, mode: SerialMode) => standings[standing](mode),
  errors,
  reception,
  speed: 'Speed, bit/s',
  notASpeed: 'A speed is a whole number from 50 to 4000000.',
  format: 'Character',
  levels: 'Levels',
  levelKinds: { rs485: 'RS-485', rs232: 'RS-232', ttl: 'TTL' } satisfies Record<LevelKind, string>,
  levelNotes: {
    rs485:
      'Two wires mirror each other. On an idle line, and for a 1, D1 is above D0 (SL 3.3.2). The specification also calls D1 B and D0 A, after TIA-485. Many makers name them the other way round, A for the wire that is higher when idle. So measure the idle line rather than trust the letters.',
    rs232: 'A line upside down: 1 and idle are −3 to −15 V, 0 is +3 to +15 V, against signal ground.',
    ttl: 'Between the controller and its line driver: 1 and idle are high (3.3 or 5 V), 0 is low.',
  },
  tracks: {
    d1: { name: 'D1 (B)', high: '+', low: '−' },
    d0: { name: 'D0 (A)', high: '+', low: '−' },
    rs232: { name: 'RS-232', high: '+12 V', low: '−12 V' },
    ttl: { name: 'TTL', high: 'high', low: 'low' },
  },
  delay: 'Reply after, ms',
  notADelay: 'A time in milliseconds, 0 to 2000, such as 5 or 0.5.',
  gapAt: 'Gap before byte',
  gapAtHint: (last: number) => `1 to ${last}; blank for no gap.`,
  notAGapAt: (last: number) => `A byte from 1 to ${last}, or blank for no gap.`,
  gapTime: 'Gap, ms',
  gap: (length: string, effect: GapEffect) => `A gap of ${length} is ${gapEffects[effect]}.`,
  asciiGap: (length: string, effect: GapEffect) =>
    effect === 'whole'
      ? `A gap of ${length} is allowed in ASCII: up to 1 s may pass between characters.`
      : `A gap of ${length} is longer than 1 s: a receiver may discard the frame.`,
  silences: (t15: string, t35: string) => `t1.5 is ${t15}, t3.5 is ${t35}.`,
  noSilences: 'ASCII needs no silence: a colon begins a frame, and up to 1 s may pass between characters.',
  fromDevice: (name: string) => `Set as for ${name}.`,
  character: (bits: number, length: string) => `A character has ${bits} bits and takes ${length}.`,
  frame: (direction: 'request' | 'response', size: number, length: string) =>
    `${direction === 'request' ? 'Request' : 'Reply'}, ${bytesOf(size)}, ${length}`,
  bytes: bytesOf,
  expected: 'The reply is the expected one. What only the device knows is 0 in it, or an example.',
  gapMark: (length: string) => `gap ${length}`,
  delayMark: (length: string) => `silence ${length}`,
  t15: (length: string) => `t1.5 ${length}`,
  t35: (length: string) => `t3.5 ${length}`,
  bitNames: { start: 'start', parity: 'parity', stop: 'stop' },
  bitLetters: { start: 'St', parity: 'P', stop: 'Sp' },
  legend: 'St start bit, 0 to 7 data bits with the least significant first, P parity bit, Sp stop bit.',
  timeRow: 'time',
  readRow: 'read as',
  view: 'Waveform. Arrow keys scroll, + and − zoom, 0 shows all, Home and End go to the ends.',
  picture: (frames: readonly string[], line: string) => `Waveform of a serial line, ${line}: ${frames.join('; ')}.`,
  zoom: 'Zoom',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  zoomTo: { all: 'All', frame: 'Frame', byte: 'Byte', bit: 'Bit' },
  zoomHints: {
    all: 'The whole exchange',
    frame: 'The current frame, with its silences',
    byte: 'The byte nearest to the middle',
    bit: 'A bit in the middle',
  },
  zoomHint: 'Or Ctrl and the wheel; on the picture + − 0, Home and End.',
  receiver: 'A receiver with',
  receivers: {
    none: '(no receiver)',
    parity: 'another parity',
    'no-parity': 'no parity',
    'data-bits': 'other data bits',
    double: 'twice the speed',
    half: 'half the speed',
    swapped: 'its wires swapped',
    own: 'its own settings',
  } satisfies Record<ReceiverKind, string>,
  receiverSpeed: 'Its speed, bit/s',
  receiverFormat: 'Its character',
  receiverIs: (speed: number, format: string) => `It is set to ${speed} ${format}.`,
  receiverHow:
    'It looks at the middle of each bit, at the first stop bit only, and waits for the next start edge. After a wrong stop bit receivers differ, so that yours may read other bytes from there on.',
  halfSpeed: 'At half the speed it looks just where the bits change, so that a real receiver may see either.',
  received: 'What it reads',
  receivedColumns: { byte: 'no.', hex: 'hex', bits: 'data bits', error: 'error', start: 'start', from: 'from byte' },
  fine: 'none',
  table: 'The bits as a table',
  columns: { byte: 'byte', hex: 'hex', field: 'field', bits: 'bits as sent', start: 'start' },
  show: (byte: string, index: number) => `Show byte ${index}, ${byte}, in the waveform`,
  tableHint: (parts: string) => `Bits as sent: ${parts}. Times count from the first start bit of the exchange.`,
  parts: { start: 'start', data: 'data, least significant first', parity: 'parity', stop: 'stop' },
  saveSvg: 'Save as SVG',
  savePng: 'Save as PNG',
  copySvg: 'Copy SVG',
  copyPng: 'Copy PNG',
  copied: 'Copied.',
  saved: (name: string) => `Saved as ${name}.`,
  refused: 'The browser refused to copy. Save the picture instead.',
  noPng: 'The browser could not draw the picture. Save it as SVG instead.',
  noFrame: 'Correct the form to see the frame.',
  empty: 'The frame has no bytes, so the line stays idle.',
  packet: {
    picture: (size: number) => `Layout of a segment of ${bytesOf(size)}, a box for each byte.`,
    mbap: (size: number) => `MBAP header, ${bytesOf(size)}`,
    pdu: (size: number) => `PDU, ${bytesOf(size)}`,
    note: (size: number) =>
      `The payload of one TCP segment, to port 502 or from it. Not drawn: the headers of Ethernet (14 bytes), IP (20, version 6: 40) and TCP (20 or more) before it, and the check of Ethernet (4 bytes) behind it. On the cable these are at least ${bytesOf(Math.max(64, size + 58))}. TCP may split the bytes or join them with others.`,
    pduNote: 'A bare PDU has no line of its own. Choose RTU, ASCII or TCP to see it carried.',
    table: 'The fields as a table',
    columns: { field: 'field', bytes: 'bytes', offset: 'from', size: 'size' },
  },
};

export type WireWords = typeof wire;
