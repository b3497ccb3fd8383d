import { type JsonFault, readJson } from '../../notation/index.ts';
import { readInFull, readLink } from '../frame/link.ts';
import { LONGEST_NAME, plainName } from '../names.ts';

/** A draft under a name: as the part of a link behind `#`, which says it all and can be read by a person. */
export interface SavedFrame {
  readonly name: string;
  readonly link: string;
}

/** Why a text is not a list of saved frames. */
export type FileFault =
  | JsonFault
  | { readonly code: 'not-saved-frames' }
  | { readonly code: 'newer-version'; readonly version: number };

/** Why one row of such a list is not a frame. */
export type RowFault = 'not-a-row' | 'no-name' | 'name-too-long' | 'no-link' | 'unknown-link' | 'newer-link';

/** A row that is not a frame, as it stands in the file, counted from 1. */
export interface BadRow {
  readonly row: number;
  readonly why: RowFault;
  readonly raw: unknown;
}

export type FileReading =
  | { readonly kind: 'list'; readonly frames: readonly SavedFrame[]; readonly bad: readonly BadRow[] }
  | { readonly kind: 'unreadable'; readonly fault: FileFault };

const FORMAT = 'framewright-frames';
const VERSION = 1;

/** The text of a file of frames, which is what the browser stores too. Rows that were not frames are kept as they are. */
export const writeSaved = (frames: readonly SavedFrame[], bad: readonly BadRow[] = []): string =>
  JSON.stringify({ format: FORMAT, version: VERSION, frames: [...frames, ...bad.map(({ raw }) => raw)] }, null, 2);

/** Reads what `writeSaved` wrote, and says of anything else why it is not that. */
export function readSaved(text: string): FileReading {
  const json = readJson(text);
  if (json.kind === 'unreadable') return json;
  const { value } = json;
  const { format, version, frames } = (value ?? {}) as Readonly<Record<string, unknown>>;
  if (format !== FORMAT || typeof version !== 'number')
    return { kind: 'unreadable', fault: { code: 'not-saved-frames' } };
  if (version > VERSION) return { kind: 'unreadable', fault: { code: 'newer-version', version } };
  if (version !== VERSION || !Array.isArray(frames)) return { kind: 'unreadable', fault: { code: 'not-saved-frames' } };
  const good: SavedFrame[] = [];
  const bad: BadRow[] = [];
  for (const [index, raw] of frames.entries()) {
    const read = readRow(raw);
    if (typeof read === 'string') bad.push({ row: index + 1, why: read, raw });
    else good.push(read);
  }
  return { kind: 'list', frames: good, bad };
}

function readRow(raw: unknown): SavedFrame | RowFault {
  if (typeof raw !== 'object' || raw === null || Array.isArray(raw)) return 'not-a-row';
  const { name, link } = raw as Readonly<Record<string, unknown>>;
  if (typeof name !== 'string' || plainName(name) === '') return 'no-name';
  if (plainName(name).length > LONGEST_NAME) return 'name-too-long';
  if (typeof link !== 'string' || link === '') return 'no-link';
  const reading = readLink(link);
  if (reading?.newer !== undefined) return 'newer-link';
  return reading === undefined || !readInFull(reading) ? 'unknown-link' : { name: plainName(name), link };
}
