import type { CaptureProblem } from '../../captures/index.ts';
import { dictionary } from '../../modbus/index.ts';
import type { Place } from '../../trace/index.ts';
import type { LogSource, UntakenPart } from '../../workbench/index.ts';
import { bytesOf, grouped, plural } from './common.ts';
import { pasting } from './pasting.ts';

const number = (value: unknown) => grouped(Number(value));

/** What the kinds of links are called that captures of Modbus may have, and that are not read (the list of link-layer header types). */
const links: Readonly<Record<string, string>> = dictionary({
  105: 'Wi-Fi',
  119: 'Wi-Fi',
  127: 'Wi-Fi',
  163: 'Wi-Fi',
  187: 'Bluetooth',
  201: 'Bluetooth',
  251: 'Bluetooth',
  195: 'IEEE 802.15.4',
  230: 'IEEE 802.15.4',
  227: 'CAN',
  189: 'USB',
  220: 'USB',
  249: 'USB',
});

/** What is wrong with a file of traffic, or was left out of it. */
const problems: Readonly<Record<string, (data: Readonly<Record<string, unknown>>) => string>> = dictionary({
  empty: () => 'There is nothing in it.',
  gzipped: () => 'It is packed once more.',
  'cut-off': () => 'The file ends in the middle of this.',
  'block-broken': () => 'This block of the capture is broken, and is left out.',
  'interface-unknown': () => 'This packet belongs to an interface that the capture does not describe.',
  'link-unknown': ({ link, packets }) =>
    link === undefined || links[String(link)] === undefined
      ? `${plural(Number(packets), 'packet')} of a kind of link that is not known here: ${number(link)}.`
      : `${plural(Number(packets), 'packet')} of ${links[String(link)]}, which is not read here.`,
  encrypted: () => 'This connection is encrypted (TLS), so that what it carries cannot be read.',
  'no-modbus': ({ packets }) => `None of the ${plural(Number(packets), 'packet')} carries Modbus.`,
  'packet-cut': () => 'This packet was not captured in full.',
  'segment-lost': () => 'A part of this TCP stream was not captured. Reading goes on at the next frame.',
  'frame-cut': () => 'A frame is cut off here.',
  'left-over': () => 'Bytes of this TCP stream are in no frame.',
  'no-frame': () => 'These bytes are in no frame.',
});

/** Where in its source something stands. */
function place(of: Place | undefined): string {
  if (of === undefined || of.kind === 'live') return '';
  if (of.kind === 'packet') return `Packet ${of.numbers.map(number).join(', ')}`;
  if (of.kind === 'text') return `Character ${number(of.from + 1)}`;
  return `${bytesOf(of.to - of.from)} from byte ${number(of.from)}`;
}

/** A problem of a file: where it is, and what it is. Texts have the problems of a pasted text, too. */
export function traceProblem({ code, place: at, ...data }: CaptureProblem): string {
  const inText = dictionary(pasting.problems as unknown as typeof problems)[code];
  const said = (problems[code] ?? inText)?.(data) ?? code;
  const where = place(at);
  return where === '' ? said : `${where}: ${said}`;
}

/** Why a part of the address was not taken. */
const untaken = {
  'not-known': 'it can have log, filter, rows, row and tab only.',
  log: 'a log is named demo.',
  rows: 'a row is a frame or an exchange.',
  row: 'a row is named by the number of its frame.',
  tab: 'the tabs are rows, timeline, statistics and values.',
} satisfies Record<UntakenPart['code'], string>;

/** Characters that are shown of a part. */
const SHOWN = 40;

/** What the address of a log says, and could not be done. */
export const ofAddress = {
  /** In place of a log that the address is of. */
  notKept: (source: LogSource | undefined) =>
    source === 'file'
      ? 'The log of this address was opened from a file, which is not kept. Open it again: the filter and the frame of the address are applied to it.'
      : source === 'pasted'
        ? 'The log of this address was pasted, and is not kept. Paste it again: the filter and the frame of the address are applied to it.'
        : 'This address names no log. Its filter and its frame are applied to the one that is opened next.',
  untaken: ({ code, name, text }: UntakenPart) =>
    `The address says “${name}=${text.slice(0, SHOWN)}${text.length > SHOWN ? '…' : ''}”, but ${untaken[code]}`,
  missing: (record: number, frames: number) =>
    record < frames
      ? `The filter leaves out frame ${grouped(record + 1)}, which the address names.`
      : `The address names frame ${grouped(record + 1)}, but the log has ${plural(frames, 'frame')}.`,
};
