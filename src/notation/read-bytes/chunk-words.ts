import type { ChunkLabel } from './types.ts';

/** What one word of a log says of the bytes beside it. */
export type ChunkWord = Omit<ChunkLabel, 'time'>;

const words = (label: ChunkWord, list: string) => list.split(' ').map((word) => [word, label] as const);

const ANYWHERE: ReadonlyMap<string, ChunkWord> = new Map([
  ...words({ direction: 'tx' }, 'tx txd send sent sends sending transmit transmitted transmitting written writing'),
  ...words({ direction: 'rx' }, 'rx rxd recv recvd receive received receives receiving'),
  ...words({ direction: 'request' }, 'request req query indication'),
  ...words({ direction: 'response' }, 'response resp rsp reply replied answer'),
  ...words({ transport: 'rtu' }, 'rtu'),
  ...words({ transport: 'tcp' }, 'tcp mbap'),
  ...words({ transport: 'ascii' }, 'ascii'),
]);

/** Words with other meanings too, which count only where a colon or a bracket ends them. */
const AS_LABEL: ReadonlyMap<string, ChunkWord> = new Map([
  ...words({ direction: 'tx' }, 'write out t w'),
  ...words({ direction: 'rx' }, 'read in r'),
  ...words({ direction: 'request' }, 'master client poll q'),
  ...words({ direction: 'response' }, 'slave server confirmation'),
]);

/** What a word says that ends at `to` of the line, if anything. */
export function chunkWord(word: string, line: string, to: number): ChunkWord | undefined {
  const lower = word.toLowerCase();
  return ANYWHERE.get(lower) ?? (/[:>\]]/.test(line[to] ?? '') ? AS_LABEL.get(lower) : undefined);
}

const ARROW = /(?:<{2,3}(?=[\s:]|$)|>{2,3}(?=[\s:]|$)|<[-=]{1,2}(?!>)|[-=]{1,2}>)/y;

/** The arrow that stands at a place of a line: `>>>`, `<--`, `=>`; right is sent, left is received. */
export function arrowAt(line: string, at: number): { readonly word: ChunkWord; readonly end: number } | undefined {
  ARROW.lastIndex = at;
  const arrow = ARROW.exec(line)?.[0];
  if (arrow === undefined) return undefined;
  return { word: { direction: arrow.includes('>') ? 'tx' : 'rx' }, end: at + arrow.length };
}
