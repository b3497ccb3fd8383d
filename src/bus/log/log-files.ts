import { fromHex, spacedHex } from '../../modbus/index.ts';
import { type LineKind, type LogLine, lineKinds } from './line.ts';

/** The columns of the log as a table. */
const COLUMNS = [
  'number',
  'time',
  'direction',
  'transport',
  'kind',
  'bytes',
  'answers',
  'duration_ms',
  'verdict',
] as const;
const VERDICTS = ['good', 'doubtful', 'refused', 'bad', 'ended', 'silent', 'absent'] as const;

const cellsOf = ({ number, time, direction, transport, kind, hex, answers, duration, verdict }: LogLine): string[] => [
  String(number),
  new Date(time).toISOString(),
  direction,
  transport,
  kind,
  spacedHex(hex),
  String(answers ?? ''),
  duration === undefined ? '' : duration.toFixed(1),
  verdict ?? '',
];

/** The log as lines of text, each with its time, direction and bytes; the page reads it again when it is pasted. */
export const logAsText = (lines: readonly LogLine[]): string =>
  lines
    .map(
      ({ time, direction, hex }) =>
        `${new Date(time).toISOString()} ${direction === 'sent' ? 'TX' : 'RX'} ${spacedHex(hex)}\n`,
    )
    .join('');

/** The log as a table with commas; no cell contains a comma. */
export const logAsCsv = (lines: readonly LogLine[]): string =>
  [COLUMNS, ...lines.map(cellsOf)].map((cells) => `${cells.join(',')}\r\n`).join('');

/** The log as JSON, indented by so many spaces. */
export const logAsJson = (lines: readonly LogLine[], indent = 1): string =>
  `${JSON.stringify({ format: 'framewright log', version: 1, lines }, null, indent)}\n`;

/** The log in a JSON text; `undefined` if the text is not a log. */
export function logFromJson(text: string): LogLine[] | undefined {
  try {
    const { format, lines } = JSON.parse(text) as { format?: unknown; lines?: unknown };
    if (format !== 'framewright log' || !Array.isArray(lines)) return undefined;
    return numbered(lines.flatMap((line) => readLine(line) ?? []));
  } catch {
    return undefined;
  }
}

/** The log in a table whose first row names the columns, in any order; `undefined` if the table is not a log. */
export function logFromRows([head, ...rows]: readonly (readonly string[])[]): LogLine[] | undefined {
  const place = (name: (typeof COLUMNS)[number]) => head?.findIndex((cell) => cell.trim() === name) ?? -1;
  if (place('time') < 0 || place('bytes') < 0 || place('direction') < 0) return undefined;
  return numbered(
    rows.flatMap((row) => {
      const cell = (name: (typeof COLUMNS)[number]) => row[place(name)]?.trim() ?? '';
      const number = (text: string) => (text === '' ? undefined : Number(text.replace(',', '.')));
      const line = {
        number: number(cell('number')),
        time: Date.parse(cell('time')),
        direction: cell('direction'),
        transport: cell('transport'),
        kind: cell('kind'),
        hex: cell('bytes').replaceAll(' ', ''),
        answers: number(cell('answers')),
        duration: number(cell('duration_ms')),
        verdict: cell('verdict') || undefined,
      };
      return readLine(line) ?? [];
    }),
  );
}

/** A line out of a file; `undefined` if a part is missing or wrong. */
function readLine(value: unknown): LogLine | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const { number, time, direction, transport, kind, hex, answers, duration, verdict } = value as Record<
    string,
    unknown
  >;
  if (!isNumber(time) || typeof hex !== 'string' || hex === '' || fromHex(hex) === undefined) return undefined;
  return {
    number: isNumber(number) ? number : 0,
    time,
    direction: direction === 'sent' ? 'sent' : 'received',
    transport: transport === 'ascii' ? 'ascii' : 'rtu',
    kind: oneOf<LineKind>(lineKinds, kind) ?? 'heard',
    hex: hex.toUpperCase(),
    ...(isNumber(answers) && { answers }),
    ...(isNumber(duration) && { duration }),
    ...orNothing(oneOf(VERDICTS, verdict)),
  };
}

const isNumber = (value: unknown): value is number => Number.isFinite(value);
const oneOf = <T>(known: readonly T[], value: unknown): T | undefined => known.find((one) => one === value);
const orNothing = (verdict: LogLine['verdict']) => (verdict === undefined ? {} : { verdict });

/** Numbers the lines from 1, and changes what they answer accordingly. */
export function numbered(lines: readonly LogLine[]): LogLine[] {
  const places = new Map(lines.map(({ number }, index) => [number, index + 1]));
  return lines.map(({ answers, ...line }, index) => {
    const asked = answers === undefined ? undefined : places.get(answers);
    return { ...line, number: index + 1, ...(asked !== undefined && { answers: asked }) };
  });
}
