import { type JsonFault, readJson } from '../notation/index.ts';
import { listNames, type StepKind, type StepPlace } from './sequence.ts';
import { type SequenceTexts, type StepTexts, stepFields, stepKinds } from './texts.ts';

/** Why a text is not a list of sequences. */
export type SequenceFileFault =
  | JsonFault
  | { readonly code: 'not-sequences' }
  | { readonly code: 'newer-version'; readonly version: number };

/**
 * Why a sequence of a file was not taken: without a step it would be another. What is only not right yet is taken as it
 * stands, and `readSequence` says what it is.
 */
export type ShapeFault =
  | { readonly code: 'no-name' }
  | { readonly code: 'not-a-transport'; readonly got: string }
  | { readonly code: 'not-a-list'; readonly place: StepPlace }
  | { readonly code: 'not-a-step'; readonly place: StepPlace; readonly got: string }
  | { readonly code: 'field-unknown'; readonly place: StepPlace; readonly field: string }
  | { readonly code: 'too-deep'; readonly place: StepPlace; readonly most: number }
  | { readonly code: 'too-many'; readonly got: number; readonly most: number };

export type SequenceEntry =
  | { readonly kind: 'sequence'; readonly sequence: SequenceTexts }
  /** `number` is that in the list, from 1; `raw` is the entry as it stands in the file. */
  | {
      readonly kind: 'faults';
      readonly number: number;
      readonly name: string;
      readonly faults: readonly ShapeFault[];
      readonly raw: unknown;
    };

export type SequencesReading =
  | { readonly kind: 'sequences'; readonly entries: readonly SequenceEntry[] }
  | { readonly kind: 'unreadable'; readonly fault: SequenceFileFault };

const FORMAT = 'framewright-sequences';
const VERSION = 1;
export const MOST_STEPS = 500;
/** Repetitions within repetitions. */
export const DEEPEST = 4;

type Loose = Readonly<Record<string, unknown>>;

const isObject = (value: unknown): value is Loose =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** The text of a file of sequences, which is what the browser keeps too; `others` are entries that stay as they were read. */
export const writeSequences = (sequences: readonly SequenceTexts[], others: readonly unknown[] = []): string =>
  JSON.stringify(
    {
      format: FORMAT,
      version: VERSION,
      sequences: [...sequences.map(looseSequence), ...others],
    },
    null,
    2,
  );

const looseSequence = ({ steps, finally: last, ...others }: SequenceTexts): Loose => ({
  ...others,
  steps: steps.map(looseStep),
  finally: last.map(looseStep),
});

/** Decimal numbers become numbers in the file, as programs write them. */
const looseStep = ({ kind, fields, steps }: StepTexts): Loose => ({
  kind,
  ...Object.fromEntries(
    Object.entries(fields).map(([name, text]) => [name, /^(0|-?[1-9]\d{0,14})$/.test(text) ? Number(text) : text]),
  ),
  ...(steps && { steps: steps.map(looseStep) }),
});

/**
 * Reads what `writeSequences` wrote, and what is like it. A frame may be a `link` in place of `bytes`: `bytesOfLink` makes its
 * bytes as hexadecimal pairs, and what it cannot make is kept as it stands. Never throws.
 */
export function readSequences(text: string, bytesOfLink: (link: string) => string | undefined): SequencesReading {
  const json = readJson(text);
  if (json.kind === 'unreadable') return json;
  const { value } = json;
  const { format, version, sequences } = isObject(value) ? value : {};
  if (format !== FORMAT || typeof version !== 'number') return { kind: 'unreadable', fault: { code: 'not-sequences' } };
  if (version > VERSION) return { kind: 'unreadable', fault: { code: 'newer-version', version } };
  if (!Array.isArray(sequences)) return { kind: 'unreadable', fault: { code: 'not-sequences' } };
  return {
    kind: 'sequences',
    entries: sequences.map((raw, index) => readEntry(raw, index + 1, bytesOfLink)),
  };
}

const textOf = (value: unknown): string =>
  typeof value === 'string' ? value : value === undefined ? '' : JSON.stringify(value);

function readEntry(raw: unknown, number: number, bytesOfLink: (link: string) => string | undefined): SequenceEntry {
  const entry = isObject(raw) ? raw : {};
  const faults: ShapeFault[] = [];
  let count = 0;

  const readList = (value: unknown, place: StepPlace): readonly StepTexts[] => {
    if (!Array.isArray(value)) {
      faults.push({ code: 'not-a-list', place });
      return [];
    }
    if (place.at.length > DEEPEST) {
      faults.push({ code: 'too-deep', place, most: DEEPEST });
      return [];
    }
    count += value.length;
    return value.flatMap((step, index) => readStep(step, { list: place.list, at: [...place.at, index] }));
  };

  const readStep = (value: unknown, place: StepPlace): readonly StepTexts[] => {
    const { kind: kindText, steps, link, ...others } = isObject(value) ? value : {};
    const kind = stepKinds.find((each) => each === kindText);
    if (kind === undefined) {
      faults.push({ code: 'not-a-step', place, got: textOf(kindText) });
      return [];
    }
    const loose: Loose =
      kind === 'send' && typeof link === 'string' ? { bytes: bytesOfLink(link) ?? link, ...others } : others;
    const fields = fieldsOf(kind, loose, place);
    return [{ kind, fields, ...(kind === 'repeat' && { steps: readList(steps, place) }) }];
  };

  const fieldsOf = (kind: StepKind, loose: Loose, place: StepPlace): StepTexts['fields'] => {
    const usual = stepFields[kind];
    for (const field of Object.keys(loose))
      if (!Object.hasOwn(usual, field)) faults.push({ code: 'field-unknown', place, field });
    return Object.fromEntries(
      Object.entries(usual).map(([field, text]) => [field, Object.hasOwn(loose, field) ? textOf(loose[field]) : text]),
    );
  };

  const name = textOf(entry['name']).trim().replace(/\s+/g, ' ').slice(0, 200);
  if (name === '') faults.push({ code: 'no-name' });
  const transport = entry['transport'];
  if (transport !== 'rtu' && transport !== 'ascii') faults.push({ code: 'not-a-transport', got: textOf(transport) });
  const [steps = [], last = []] = listNames.map((list) => readList(entry[list] ?? [], { list, at: [] }));
  if (count > MOST_STEPS) faults.push({ code: 'too-many', got: count, most: MOST_STEPS });
  if (faults.length > 0) return { kind: 'faults', number, name, faults, raw };
  return {
    kind: 'sequence',
    sequence: {
      name,
      about: textOf(entry['about']),
      transport: transport === 'ascii' ? 'ascii' : 'rtu',
      steps,
      finally: last,
    },
  };
}
