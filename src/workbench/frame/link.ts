import type { Transport } from '../../modbus/index.ts';
import { type Draft, type FrameKind, firstDraft } from './draft.ts';
import type { Control } from './evaluate.ts';
import { readQuery, writeQuery } from './query.ts';

const TRANSPORTS: readonly Transport[] = ['rtu', 'ascii', 'tcp', 'pdu'];
const KINDS: readonly FrameKind[] = ['request', 'reply', 'exception'];
const FORCE = 'force.';
const ANSWERING = 'answering';
const BYTES = 'bytes';

/** What a link holds, and the parts of it that mean nothing here. */
export interface LinkReading {
  readonly draft: Draft;
  readonly unknown: readonly string[];
}

/** A link that could not be read in full: all of it, and the parts that mean nothing here. */
export interface BrokenLink {
  readonly text: string;
  readonly unknown: readonly string[];
}

/** The paths of the texts that the form shows now. */
function* paths(controls: readonly Control[]): Generator<string> {
  for (const { path, derived, groups } of controls) {
    if (!derived) yield path;
    for (const group of groups) yield* paths(group);
  }
}

/**
 * The draft as the part of an address behind `#`, as typed, valid or not: `rtu/request?unitId=6&functionCode=6&address=0x2AB`.
 * Texts of fields that the form does not show are left out.
 */
export function writeLink(draft: Draft, controls: readonly Control[]): string {
  const query: [string, string][] = [];
  const envelope = ['transactionId', 'unitId', 'functionCode'];
  for (const path of [...envelope, ...paths(controls)]) {
    const text = draft.texts[path];
    if (text !== undefined) query.push([path, text]);
  }
  for (const [name, text] of Object.entries(draft.force)) query.push([FORCE + name, text]);
  if (draft.answering !== '' && draft.kind !== 'request') query.push([ANSWERING, draft.answering]);
  if (draft.bytes !== undefined) query.push([BYTES, draft.bytes]);
  // Brackets read better unescaped, and are safe behind #.
  const text = writeQuery(query).replaceAll('%5B', '[').replaceAll('%5D', ']');
  return `${draft.transport}/${draft.kind}?${text}`;
}

/** Reads what `writeLink` wrote, or `undefined` for an address without a frame. */
export function readLink(hash: string): LinkReading | undefined {
  const text = hash.replace(/^#/, '');
  if (text === '') return undefined;
  const [path = '', query = ''] = splitOnce(text, '?');
  const [transportText = '', kindText = ''] = splitOnce(path, '/');
  const transport = TRANSPORTS.find((known) => known === transportText);
  const kind = KINDS.find((known) => known === kindText);
  const unknown: string[] = [];
  if (transport === undefined || kind === undefined) unknown.push(path);
  const texts: Record<string, string> = {};
  const force: Record<string, string> = {};
  let answering = '';
  let bytes: string | undefined;
  for (const [name, value] of readQuery(query)) {
    if (name === ANSWERING) answering = value;
    else if (name === BYTES) bytes = value;
    else if (name in {}) unknown.push(name);
    else if (name.startsWith(FORCE) && !(name.slice(FORCE.length) in {})) force[name.slice(FORCE.length)] = value;
    else if (/^[a-z]\w*(\[\d+\]\.[a-z]\w*)?$/i.test(name)) texts[name] = value;
    else unknown.push(name);
  }
  const empty = transport === undefined && Object.keys(texts).length === 0;
  const draft = empty
    ? firstDraft
    : { transport: transport ?? 'rtu', kind: kind ?? 'request', texts, force, answering, bytes };
  return { draft, unknown };
}

function splitOnce(text: string, separator: string): readonly string[] {
  const at = text.indexOf(separator);
  return at < 0 ? [text] : [text.slice(0, at), text.slice(at + separator.length)];
}
