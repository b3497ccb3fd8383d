import { dictionary, fromHex } from '../modbus/index.ts';
import { readJson } from '../notation/index.ts';
import { clockTime } from './clock.ts';
import { Found } from './found.ts';
import type { CaptureProblem } from './packet.ts';
import { Stream } from './stream.ts';

/** What a packet of tshark's output says. */
interface Row {
  readonly number: number;
  readonly time: number;
  readonly from: string;
  readonly to: string;
  readonly ports: readonly [number, number];
  readonly payload: Uint8Array;
  readonly seq: number | undefined;
}

type Loose = Readonly<Record<string, unknown>>;
const isObject = (value: unknown): value is Loose =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A field of tshark's JSON: its first value, wherever it stands in the layers of the packet. */
function field(layers: Loose, ...names: readonly string[]): string | undefined {
  for (const name of names) {
    const direct = first(layers[name]);
    if (direct !== undefined) return direct;
    const layer = layers[name.slice(0, name.indexOf('.'))];
    for (const one of Array.isArray(layer) ? layer : [layer]) {
      const inside = isObject(one) ? first(one[name]) : undefined;
      if (inside !== undefined) return inside;
    }
  }
  return undefined;
}

const first = (value: unknown): string | undefined => {
  const one: unknown = Array.isArray(value) ? value[0] : value;
  return typeof one === 'string' || typeof one === 'number' ? String(one) : undefined;
};

const payloadOf = (text: string | undefined): Uint8Array | undefined =>
  text === undefined ? undefined : fromHex(text.replaceAll(':', ''));

/** The packets of `tshark -T json`; `undefined` if the text is not that. */
function jsonRows(text: string): readonly Row[] | undefined {
  if (!/^\s*\[\s*\{/.test(text) || !text.slice(0, 4096).includes('"layers"')) return undefined;
  const json = readJson(text);
  if (json.kind === 'unreadable' || !Array.isArray(json.value)) return undefined;
  return json.value.flatMap((entry: unknown, index) => {
    const source = isObject(entry) ? entry['_source'] : undefined;
    const layers = isObject(source) ? source['layers'] : undefined;
    return isObject(layers) ? rowOf((...names) => field(layers, ...names), index) : [];
  });
}

function rowOf(get: (...names: readonly string[]) => string | undefined, index: number): Row[] {
  const payload = payloadOf(get('tcp.payload', 'udp.payload', 'data.data'));
  if (payload === undefined || payload.length === 0) return [];
  const ports = [get('tcp.srcport', 'udp.srcport'), get('tcp.dstport', 'udp.dstport')].map(Number);
  const seq = Number(get('tcp.seq_raw', 'tcp.seq'));
  const time = clockTime(get('frame.time_epoch', 'frame.time_relative', 'frame.time') ?? '')?.time;
  const end = (address: string | undefined, port: number | undefined) =>
    `${address ?? ''}:${Number.isNaN(port ?? Number.NaN) ? '' : port}`;
  return [
    {
      number: Number(get('frame.number') ?? index + 1),
      time: time ?? Number.NaN,
      from: end(get('ip.src', 'ipv6.src'), ports[0]),
      to: end(get('ip.dst', 'ipv6.dst'), ports[1]),
      ports: [ports[0] || 0, ports[1] || 0],
      payload,
      seq: Number.isNaN(seq) ? undefined : seq,
    },
  ];
}

const PAIRS = /^(?:[0-9a-f]{2}(?::?[0-9a-f]{2}){6,})(?:,[0-9a-f:]+)*$/i;
const ADDRESS = /^(?:\d{1,3}(?:\.\d{1,3}){3}|[0-9a-f]*:[0-9a-f:]+)$/i;
const EPOCH = /^\d{1,12}\.\d{3,9}$/;
const COUNT = /^\d{1,10}$/;
const MOST_PORT = 65_535;
/** One line in so many may have no columns. */
const FEW_OTHERS = 10;
/** Characters of the names of the columns that are looked at. */
const LONGEST_HEADER = 2000;

const NAME = /^(?:frame|ip|ipv6|tcp|udp|data)\.\w+$/;
const SEPARATORS = ['\t', ',', ';', '|', ' '] as const;
/** Cells with quotes around them, or without. */
const CELLS = dictionary<RegExp>(
  Object.fromEntries(SEPARATORS.map((one) => [one, new RegExp(`("[^"]*"|'[^']*'|[^${one}]*)(?:[${one}]|$)`, 'g')])),
);

const cellsOf = (line: string, separator: string): readonly string[] =>
  Array.from(line.matchAll(CELLS[separator] ?? /.*/g), ([, cell = '']) => cell.replace(/^(["'])(.*)\1$/, '$2'));

/** The packets of `tshark -T fields -E header=y`, whatever stands between its columns; `undefined` if it names none. */
function namedRows(text: string): readonly Row[] | undefined {
  const lines = text.split(/\r?\n/).filter((line) => line !== '');
  const separator = SEPARATORS.find((one) => {
    const names = lines[0]?.length === undefined ? [] : cellsOf(lines[0].slice(0, LONGEST_HEADER), one).filter(Boolean);
    return names.length > 1 && names.every((name) => NAME.test(name) || name.startsWith('modbus.'));
  });
  if (separator === undefined) return undefined;
  const headers = cellsOf(lines[0] ?? '', separator);
  return lines.slice(1).flatMap((line, index) => {
    const cells = cellsOf(line, separator);
    return rowOf((...names) => names.map((name) => cells[headers.indexOf(name)]).find(Boolean), index);
  });
}

/** The packets of `tshark -T fields`: columns with tabs between them, of which one has payloads; `undefined` if the text is not that. */
function fieldRows(text: string): readonly Row[] | undefined {
  const written = text.split(/\r?\n/).filter((line) => line.trim() !== '');
  const lines = written.filter((line) => line.includes('\t'));
  // A stream that is followed has a tab before what one side sent.
  if (FEW_OTHERS * (written.length - lines.length) > lines.length) return undefined;
  const sample = lines.slice(0, 50).map((line) => line.split('\t'));
  const width = sample[0]?.length ?? 0;
  if (width < 2 || sample.some((cells) => cells.length !== width)) return undefined;
  const columns = Array.from({ length: width }, (_, column) =>
    sample.map((cells) => cells[column] ?? '').filter(Boolean),
  );
  const all = (form: RegExp) => (cells: readonly string[]) =>
    cells.length > 0 && cells.every((cell) => form.test(cell));
  const payload = columns.findIndex(all(PAIRS));
  if (payload < 0) return undefined;
  const addresses = columns.flatMap((cells, at) => (at !== payload && all(ADDRESS)(cells) ? [at] : []));
  const time = columns.findIndex(all(EPOCH));
  const counts = columns.flatMap((cells, at) => (all(COUNT)(cells) ? [at] : []));
  // Two columns of small numbers are the ports, of which one is Modbus' own in some row.
  const ports = counts.filter((at) => columns[at]?.every((cell) => Number(cell) <= MOST_PORT));
  const pair = ports.filter((at) => columns[at]?.includes('502') || columns[at]?.some((cell) => Number(cell) > 1024));
  const names = dictionary<number | undefined>({
    'tcp.payload': payload,
    'frame.time_epoch': time < 0 ? undefined : time,
    'ip.src': addresses[0],
    'ip.dst': addresses[1],
    'tcp.srcport': pair.at(-2),
    'tcp.dstport': pair.length > 1 ? pair.at(-1) : undefined,
  });
  return lines.flatMap((line, index) => {
    const cells = line.split('\t');
    return rowOf((...wanted) => wanted.map((name) => cells[names[name] ?? -1]).find(Boolean), index);
  });
}

/** What tshark printed, as packets; `undefined` if it is not its output. */
export function readTshark(
  text: string,
): { readonly format: string; readonly found: Found; readonly problems: readonly CaptureProblem[] } | undefined {
  const json = jsonRows(text);
  const rows = json ?? namedRows(text) ?? fieldRows(text);
  if (rows === undefined || rows.length === 0) return undefined;
  const found = new Found();
  const problems: CaptureProblem[] = [];
  const streams = new Map<string, { stream: Stream; next: [number, number] }>();
  for (const row of rows) {
    const side = row.from < row.to ? 0 : 1;
    const ends = side === 0 ? ([row.from, row.to] as const) : ([row.to, row.from] as const);
    const key = ends.join(' ');
    let known = streams.get(key);
    if (known === undefined) {
      const ports = side === 0 ? row.ports : ([row.ports[1], row.ports[0]] as const);
      known = { stream: new Stream(ends, ports, found, (problem) => problems.push(problem)), next: [0, 0] };
      streams.set(key, known);
    }
    // Without sequence numbers the order of the packets is that of their bytes.
    const seq = row.seq ?? known.next[side];
    known.next[side] = seq + row.payload.length;
    const segment = {
      seq,
      bytes: row.payload,
      from: 0,
      to: row.payload.length,
      missing: 0,
      packet: row.number,
      time: row.time,
    };
    known.stream.segment(side, 0, segment, 0);
  }
  for (const { stream } of streams.values()) stream.end();
  found.finish();
  return found.length === 0 ? undefined : { format: json ? 'tshark-json' : 'tshark-fields', found, problems };
}
