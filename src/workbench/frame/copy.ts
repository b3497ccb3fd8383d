import type { Reading } from '../../modbus/index.ts';
import type { ByteFormat } from '../../notation/index.ts';

export type CopyFormat = ByteFormat | 'ascii-line';

/** Every format, as the type demands. */
const listed: Readonly<Record<CopyFormat, true>> = {
  spaced: true,
  c: true,
  arduino: true,
  csharp: true,
  st: true,
  python: true,
  javascript: true,
  list: true,
  plain: true,
  decimal: true,
  escapes: true,
  brackets: true,
  'ascii-line': true,
};

/** The formats in the order in which they are offered, by name: how each is written comes when one is used. */
export const copyFormats = Object.keys(listed) as readonly CopyFormat[];

/** A format, and whether the checksum is copied with the frame. */
export interface CopyChoice {
  readonly format: CopyFormat;
  readonly checksum: boolean;
}

/** What is copied until something else is chosen. */
export const firstCopyFormat: CopyFormat = 'spaced';

/** The format that was stored, alone or with more; `undefined` if the value has none. */
export function readCopyFormat(value: unknown): CopyFormat | undefined {
  const { format } = (typeof value === 'object' ? (value ?? {}) : { format: value }) as { readonly format?: unknown };
  return copyFormats.find((each) => each === format);
}

/** Whether the frame has a checksum that could be left out. */
export const hasChecksum = ({ spans }: Reading): boolean => spans.some(({ kind }) => kind === 'checksum');

/** Whether the frame can be said in a format: only the ASCII line needs what a bare PDU or half a frame lacks. */
export const canCopyAs = ({ transport, unitId, outcome }: Reading, format: CopyFormat): boolean =>
  format !== 'ascii-line' || (transport !== 'pdu' && unitId !== undefined && outcome.kind === 'whole');
