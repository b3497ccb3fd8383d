import { fromHex } from '../modbus/index.ts';
import { type CaptureRecord, knownOf, readKnown } from '../trace/index.ts';
import { LogClock, type TraceFile } from './clock.ts';

const SEPARATORS = [',', ';', '\t'] as const;
const SIDES: Readonly<Record<string, CaptureRecord['side']>> = Object.freeze({
  request: 'request',
  sent: 'request',
  response: 'response',
  received: 'response',
});
/** Its head is within so many characters. */
const HEAD = 1000;

/**
 * The records of a table that this page has saved, of a trace or of its bus, also after it has been through a spreadsheet. Its head
 * names at least `time`, `bytes`, and `side` or `direction`; `undefined` if the text has no such head.
 */
export function readTraceTable(text: string): TraceFile | undefined {
  const [line = ''] = text.slice(0, HEAD).split(/\r?\n/, 1);
  const separator = SEPARATORS.find((one) => {
    const names = new Set(cellsOf(line, one));
    return names.has('time') && names.has('bytes') && (names.has('side') || names.has('direction'));
  });
  if (separator === undefined) return undefined;
  const head = cellsOf(line, separator);
  const records: CaptureRecord[] = [];
  const clock = new LogClock();
  let isUtc = false;
  for (const [from, to] of linesOf(text, line.length)) {
    const cells = cellsOf(text.slice(from, to), separator);
    const cell = (name: string) => cells[head.indexOf(name)] ?? '';
    const bytes = fromHex(cell('bytes').replaceAll(' ', ''));
    if (bytes === undefined || bytes.length === 0) continue;
    const printed = cell('time').replace(/^(\d+),(\d+)$/, '$1.$2');
    if (printed.endsWith('Z')) isUtc = true;
    const time = clock.read(printed);
    const kind = cell('kind');
    // What is heard while nobody has asked may be either.
    const said = kind === 'heard' && cell('verdict') === '' ? '' : cell('side') || cell('direction');
    const side = Object.hasOwn(SIDES, said) ? SIDES[said] : undefined;
    const transport = (['ascii', 'tcp'] as const).find((one) => one === cell('transport')) ?? 'rtu';
    const told = cell('known');
    const known = readKnown({ beside: told, outcome: told }) ?? knownOf(kind, cell('verdict'));
    // The apostrophe keeps a spreadsheet from running what stands behind it.
    const [source, destination] = [cell('from'), cell('to')].map((text) => text.replace(/^'(?=[=+\-@])/, ''));
    records.push({
      bytes,
      transport,
      // Of a count it is known from where.
      ...(time !== undefined && { time: clock.printed?.shows === 'count' ? time : clock.since(time) }),
      ...(side && { side }),
      ...(source && { from: source }),
      ...(destination && { to: destination }),
      place: { kind: 'text', from, to },
      ...(known && { known }),
    });
  }
  // The page writes a time as UTC where no source has printed another clock.
  return { records, clock: isUtc ? undefined : clock.printed };
}

/** The lines behind the head, by where they begin and end, without those that are empty. */
function* linesOf(text: string, from: number): Generator<readonly [from: number, to: number], void, undefined> {
  for (let at = from; at < text.length; ) {
    const end = text.indexOf('\n', at);
    const to = end < 0 ? text.length : end;
    if (text.slice(at, to).trim() !== '') yield [at, to];
    at = to + 1;
  }
}

/** The cells of a line (RFC 4180), without the spaces around them. */
function cellsOf(line: string, separator: string): string[] {
  const cells: string[] = [];
  let cell = '';
  let quoted = false;
  for (const character of line) {
    if (character === '"') quoted = !quoted;
    else if (character === separator && !quoted) {
      cells.push(cell.trim());
      cell = '';
    } else cell += character;
  }
  cells.push(cell.trim());
  return cells;
}
