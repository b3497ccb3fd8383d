import { diagnosticSubFunctions, dictionary, type Field, type Transport } from '../../modbus/index.ts';

/** What a person builds: a request, a reply, or the reply that refuses. */
export const frameKinds = ['request', 'reply', 'exception'] as const;
export type FrameKind = (typeof frameKinds)[number];

export const transports: readonly Transport[] = ['rtu', 'ascii', 'tcp', 'pdu'];

/**
 * What was typed, valid or not: the state of the Frame view. Everything else on the page is derived from it. `texts` has a
 * text by the path of its field (`unitId`, `registers`, `subRequests[0].fileNumber`); a path of groups holds their number.
 */
export interface Draft {
  readonly transport: Transport;
  readonly kind: FrameKind;
  readonly texts: Readonly<Record<string, string>>;
  /** Derived values that are to be other than derived, and fields that are cut off, by name. */
  readonly force: Readonly<Record<string, string>>;
  /** The request that a reply answers, as typed. */
  readonly answering: string;
  /** Bytes as typed, while they cannot be read; the form holds what could be read last. */
  readonly bytes?: string | undefined;
  /** What was typed where the field got another text made of it, by the path of its field; it holds while the field has that text. */
  readonly typed?: Readonly<Record<string, TypedText>> | undefined;
  /**
   * The other frame of a pair as it was typed: the request that this reply answers, or the reply to this request. It holds
   * while the two belong together (`pairOf`), and has no partner itself.
   */
  readonly partner?: Draft | undefined;
  /** The id of the device that gives what was typed its meaning: names of registers, units of values. */
  readonly device?: string | undefined;
}

/** `30 Hz` and `4096`, `P0683` and `HR684`. */
export interface TypedText {
  readonly typed: string;
  /** What the field got for it. */
  readonly text: string;
}

export const firstDraft: Draft = {
  transport: 'rtu',
  kind: 'request',
  texts: { unitId: '6', functionCode: '6', address: '0x02AB', value: '4096' },
  force: {},
  answering: '',
};

const BY_NAME: Readonly<Record<string, string>> = dictionary({
  fileNumber: '1',
  recordLength: '1',
  data: '00 00',
  meiData: '00 00',
  valueHex: '"Framewright"',
  subFunction: String(diagnosticSubFunctions[0].code),
});

const BY_KIND: Readonly<Record<string, string>> = dictionary({
  quantity: '1',
  registers: '0 0',
  bits: '1 0 1 1',
  groups: '1',
  list: '0',
});

/** What stands in a field until something is typed. */
export function initialText(field: Pick<Field, 'name' | 'kind' | 'allowed'>): string {
  const allowed = field.allowed?.[0];
  return BY_NAME[field.name] ?? (allowed === undefined ? (BY_KIND[field.kind] ?? '0') : String(allowed));
}

/** The text of a number of the envelope, or of the function code, typed or initial. */
export const headerText = (draft: Draft, name: 'unitId' | 'transactionId' | 'functionCode'): string =>
  draft.texts[name] ?? '1';

/** The text of a field, typed or initial. */
export const textOf = (draft: Draft, path: string, field: Pick<Field, 'name' | 'kind' | 'allowed'>): string =>
  draft.texts[path] ?? initialText(field);

export const withText = (draft: Draft, path: string, text: string): Draft => ({
  ...draft,
  texts: { ...draft.texts, [path]: text },
  typed: draft.typed && without(draft.typed, path),
  bytes: undefined,
});

function without<T>(values: Readonly<Record<string, T>>, name: string): Readonly<Record<string, T>> {
  const { [name]: _before, ...others } = values;
  return others;
}

/** The draft with a derived value forced, or left to the encoder if `text` is absent. */
export function withForce(draft: Draft, name: string, text: string | undefined): Draft {
  const others = without(draft.force, name);
  return { ...draft, force: text === undefined ? others : { ...others, [name]: text }, bytes: undefined };
}

/** The draft without group `index` of a list of groups; the groups after it move up. */
export function withoutGroup(draft: Draft, path: string, index: number, count: number): Draft {
  const texts = { ...movedUp(draft.texts, path, index), [path]: String(count - 1) };
  return { ...draft, texts, typed: draft.typed && movedUp(draft.typed, path, index), bytes: undefined };
}

function movedUp<T>(values: Readonly<Record<string, T>>, path: string, index: number): Record<string, T> {
  const moved: [string, T][] = [];
  for (const [key, value] of Object.entries(values)) {
    const match = key.startsWith(`${path}[`) ? /^\[(\d+)\](.*)$/.exec(key.slice(path.length)) : null;
    const at = Number(match?.[1]);
    if (match === null || at < index) moved.push([key, value]);
    else if (at > index) moved.push([`${path}[${at - 1}]${match[2]}`, value]);
  }
  return Object.fromEntries(moved);
}
