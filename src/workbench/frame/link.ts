import { decodeFrame } from '../../modbus/index.ts';
import { lineText, readLineText } from '../line/line-setting.ts';
import { type Draft, firstDraft, frameKinds, type TypedText, transports } from './draft.ts';
import { draftOf } from './draft-of-reading.ts';
import { type Control, evaluate, requestOf } from './evaluate.ts';
import { canForce, isFieldPath } from './forced.ts';
import { type FrameContext, firstContext, frameTabs } from './frame-context.ts';
import { alone } from './pair.ts';
import { type Query, readQuery, writeQuery } from './query.ts';
import { typedAt } from './typed.ts';

/**
 * The form of links. A change of it makes a new version and a kept link in `kept-links.test.ts`, so that every link that was
 * ever made opens the same frame. All changes so far are additions: a part is read in a link of any version, also in one that
 * was written by hand without it. A change of what a part means would need an upgrader from the version before.
 */
const VERSION = 5;
/** The version that added a person's own device. */
const WITH_PROFILE = 4;
/** The version that added the other frame of a pair, the tab, the line, and the device beside anything. */
const WITH_BESIDE = 3;
/** The version that added what was typed. */
const WITH_TYPED = 2;
/** The version of a link that does not say one. */
const FIRST = 1;

const LINK_VERSION = 'v';
const FORCE = 'force.';
const ANSWERING = 'answering';
const BYTES = 'bytes';
const TYPED = 'typed.';
const DEVICE = 'device';
const PARTNER = 'partner';
const PROFILE = 'profile';
const TAB = 'tab';
const LINE = 'line';
const PROGRAM = 'program';

/** A longer link, in characters, is not read. */
const LONGEST = 400_000;

/** What a link holds, and what of it could not be read. */
export interface LinkReading {
  readonly draft: Draft;
  /** What it says beside the frame. */
  readonly context?: FrameContext | undefined;
  /** The parts that mean nothing here. */
  readonly unknown: readonly string[];
  /** Its version, if it is one that this page does not know yet. */
  readonly newer?: number | undefined;
  /** It was too long to be read at all. */
  readonly tooLong?: boolean;
}

/** Whether all of a link was read. */
export const readInFull = ({ unknown, newer, tooLong }: LinkReading): boolean =>
  unknown.length === 0 && newer === undefined && !tooLong;

/** The paths of the texts that the form shows now. */
function* paths(controls: readonly Control[]): Generator<string> {
  for (const { path, derived, groups } of controls) {
    if (!derived) yield path;
    for (const group of groups) yield* paths(group);
  }
}

/**
 * The draft as the part of an address behind `#`, as typed, valid or not: `rtu/request?unitId=6&functionCode=6&address=0x2AB`.
 * Texts of fields that the form does not show are left out. A link has the lowest version that can hold its draft, so that
 * older pages open what they can: what was typed in units, by names or in the manual's way needs version 2, and the other frame
 * of a pair, a tab and a line need version 3, a person's own device version 4, and a program version 5.
 */
export function writeLink(draft: Draft, controls: readonly Control[], context: FrameContext = firstContext): string {
  const query: [string, string][] = [];
  const typed: [string, string][] = [];
  const envelope = ['transactionId', 'unitId', 'functionCode'];
  for (const path of [...envelope, ...paths(controls)]) {
    const text = draft.texts[path];
    if (text !== undefined) query.push([path, text]);
    const asTyped = typedAt(draft, path);
    if (asTyped !== undefined) typed.push([TYPED + path, asTyped]);
  }
  for (const [name, text] of Object.entries(draft.force)) query.push([FORCE + name, text]);
  if (draft.answering !== '' && draft.kind !== 'request') query.push([ANSWERING, draft.answering]);
  if (draft.bytes !== undefined) query.push([BYTES, draft.bytes]);
  if (typed.length > 0) {
    query.push(...typed);
    if (draft.device !== undefined) query.push([DEVICE, draft.device]);
  }
  const named = query.some(([name]) => name === DEVICE);
  const beside = writeBeside(draft, named ? { ...context, device: undefined } : context);
  if (context.profile !== undefined) beside.push([PROFILE, context.profile]);
  if (context.program !== undefined) beside.push([PROGRAM, context.program]);
  const version =
    context.tab === PROGRAM
      ? VERSION
      : context.profile !== undefined
        ? WITH_PROFILE
        : beside.length > 0
          ? WITH_BESIDE
          : typed.length > 0
            ? WITH_TYPED
            : FIRST;
  if (version > FIRST) query.unshift([LINK_VERSION, String(version)]);
  query.push(...beside);
  // Brackets read better unescaped, and are safe behind #.
  const text = writeQuery(query).replaceAll('%5B', '[').replaceAll('%5D', ']');
  return `${draft.transport}/${draft.kind}?${text}`;
}

/** What a link holds beside its frame. */
function writeBeside(draft: Draft, { tab, line, device }: FrameContext): [string, string][] {
  const query: [string, string][] = [];
  const partner = draft.partner && linkOf(draft.partner);
  if (partner !== undefined && partner !== plainRequestLink(draft)) query.push([PARTNER, partner]);
  if (tab !== firstContext.tab) query.push([TAB, tab]);
  if (line !== undefined) query.push([LINE, lineText(line)]);
  if (device !== undefined) query.push([DEVICE, device]);
  return query;
}

const linkOf = (draft: Draft): string => writeLink(draft, evaluate(draft).controls);

/** The link to the request that a reply answers, as its bytes alone have it; it is not written a second time. */
function plainRequestLink(draft: Draft): string | undefined {
  const bytes = requestOf(draft);
  if (bytes === undefined) return undefined;
  return linkOf(draftOf(decodeFrame(bytes, { transport: draft.transport, direction: 'request' }), undefined));
}

/** Reads what `writeLink` of any version wrote; `undefined` for an address without a frame. */
export function readLink(hash: string): LinkReading | undefined {
  const text = hash.replace(/^#/, '');
  if (text === '') return undefined;
  if (text.length > LONGEST) return { draft: firstDraft, unknown: [], tooLong: true };
  const [path = '', queryText = ''] = splitOnce(text, '?');
  const [transportText = '', kindText = ''] = splitOnce(path, '/');
  const transport = transports.find((known) => known === transportText);
  const kind = frameKinds.find((known) => known === kindText);
  const unknown: string[] = [];
  if (transport === undefined || kind === undefined) unknown.push(path);
  const { query, newer } = unversioned(readQuery(queryText));
  const texts = new Map<string, string>();
  const force = new Map<string, string>();
  const typed = new Map<string, string>();
  let answering = '';
  let bytes: string | undefined;
  let device: string | undefined;
  let partner: Draft | undefined;
  let { tab, line, profile, program } = firstContext;
  for (const [name, value] of query) {
    if (name === ANSWERING) answering = value;
    else if (name === BYTES) bytes = value;
    else if (name === DEVICE) device = value;
    else if (name === PROFILE) profile = value;
    else if (name === PROGRAM) program = value;
    else if (name === PARTNER) partner = readLink(value)?.draft;
    else if (name === TAB && isTab(value)) tab = value;
    else if (name === LINE && readLineText(value)) line = readLineText(value);
    else if (name.startsWith(FORCE) && canForce(name.slice(FORCE.length))) force.set(name.slice(FORCE.length), value);
    else if (name.startsWith(TYPED) && isFieldPath(name.slice(TYPED.length)))
      typed.set(name.slice(TYPED.length), value);
    else if (isFieldPath(name)) texts.set(name, value);
    else unknown.push(name);
  }
  const draft: Draft =
    transport === undefined && texts.size === 0
      ? firstDraft
      : {
          transport: transport ?? 'rtu',
          kind: kind ?? 'request',
          texts: Object.fromEntries(texts),
          force: Object.fromEntries(force),
          answering,
          bytes,
          ...(typed.size > 0 && { typed: typedTexts(typed, texts) }),
          ...(device !== undefined && { device }),
          ...(partner && { partner: alone(partner) }),
        };
  const context =
    tab === firstContext.tab && !line && !profile ? undefined : { tab, line, device: undefined, profile, program };
  return { draft, context, unknown, newer };
}

const isTab = (text: string): text is FrameContext['tab'] => frameTabs.some((known) => known === text);

const typedTexts = (typed: ReadonlyMap<string, string>, texts: ReadonlyMap<string, string>) =>
  Object.fromEntries(
    Array.from(typed, ([path, text]): [string, TypedText] => [path, { typed: text, text: texts.get(path) ?? '' }]),
  );

/** The parts of a query without its version; `newer` if that is one that this page does not know. */
function unversioned(query: Query): { readonly query: Query; readonly newer: number | undefined } {
  const said = query.find(([name, value]) => name === LINK_VERSION && /^[1-9]\d{0,8}$/.test(value));
  const version = said ? Number(said[1]) : FIRST;
  return { query: query.filter((part) => part !== said), newer: version > VERSION ? version : undefined };
}

function splitOnce(text: string, separator: string): readonly string[] {
  const at = text.indexOf(separator);
  return at < 0 ? [text] : [text.slice(0, at), text.slice(at + separator.length)];
}
