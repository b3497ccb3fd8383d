import {
  estimateScan,
  isSameLine,
  type LinkSettings,
  lineTimes,
  type ScanFinding,
  type ScanNews,
  type ScanOrder,
  type TransactionRules,
  type TrialNews,
  type TrialOrder,
} from '../../bus/index.ts';
import {
  accessOf,
  decodeFrame,
  encodeFrame,
  FIRST_UNIT,
  LAST_UNIT,
  readerOf,
  type SerialMode,
} from '../../modbus/index.ts';
import { defaultScan, formatsFor, scanOrder } from './scan-settings.ts';

/** What is looked at when no device has answered, in this order. */
export const noAnswerSteps = ['unit', 'line', 'echo', 'gap', 'length', 'wires', 'termination', 'power'] as const;
export type NoAnswerStep = (typeof noAnswerSteps)[number];

/** A request that nobody has answered. */
export interface Unanswered {
  readonly request: Uint8Array;
  readonly transport: SerialMode;
}

/** What a step has found. */
export type StepFinding =
  | { readonly code: 'unit-answers'; readonly unit: number }
  | { readonly code: 'others-answer'; readonly unit: number; readonly units: readonly number[] }
  | { readonly code: 'none-answers'; readonly asked: number }
  | { readonly code: 'line-answers'; readonly settings: LinkSettings; readonly current: boolean }
  | { readonly code: 'lines-silent'; readonly tried: number; readonly notOpened: number }
  /** The request came back, so that it was sent. */
  | { readonly code: 'returned' }
  | { readonly code: 'nothing-returned' }
  /** The device answered when this was tried. */
  | { readonly code: 'answered'; readonly trial: 'no-echo' | 'silence-before' | 'wait-longer' | 'half' }
  | { readonly code: 'still-silent' }
  /** It was ended before it had found anything. */
  | { readonly code: 'stopped'; readonly done: number; readonly total: number }
  /** Somebody has looked at it. */
  | { readonly code: 'checked' }
  /** What another step has found rules it out. */
  | { readonly code: 'ruled-out'; readonly by: NoAnswerStep };

/** `excluded`: this is not why; `found`: it is, or it is near. */
export type StepState = 'open' | 'running' | 'excluded' | 'found';

export interface StepMark {
  readonly state: StepState;
  readonly finding?: StepFinding | undefined;
}

/** What a step does. `time` is how long it takes at most, in milliseconds. */
export type StepPlan =
  | { readonly kind: 'scan'; readonly order: ScanOrder; readonly time: number }
  | { readonly kind: 'trials'; readonly order: TrialOrder; readonly time: number }
  /** Nothing that a page could look at. */
  | { readonly kind: 'by-hand' }
  /** The request cannot be shorter, or names no unit. */
  | { readonly kind: 'impossible' };

/** The line as it is open, or would be opened. */
export interface StepLine {
  readonly settings: LinkSettings;
  readonly rules: TransactionRules;
}

/** The likeliest first. */
const SPEEDS = [9600, 19_200, 38_400, 115_200, 57_600, 4800, 2400, 1200];
const MOST_FORMATS = 4;
/** Milliseconds that a unit is waited for: it is asked for one register, or at another speed. */
const UNIT_WAIT = 100;
const LINE_WAIT = 300;
/** A silence before the request that is long enough for any device, and the longest wait for a reply. */
const LONG_SILENCE = 100;
const LONG_WAIT = 5000;

/** What a step does about a request. */
export function planOf(step: NoAnswerStep, { request, transport }: Unanswered, line: StepLine): StepPlan {
  const { unitId } = decodeFrame(request, { transport, direction: 'request' });
  const scan = (order: ScanOrder | undefined): StepPlan =>
    order ? { kind: 'scan', order, time: estimateScan(order, line.settings, line.rules).time } : { kind: 'impossible' };
  const trials = (...given: TrialOrder['trials']): StepPlan => {
    const order: TrialOrder = { kind: 'trials', transport, trials: given };
    return { kind: 'trials', order, time: trialsTime(order, line) };
  };
  switch (step) {
    case 'unit':
      return scan(
        scanOrder(
          { ...defaultScan, transport, timeout: UNIT_WAIT, firstUnit: FIRST_UNIT, lastUnit: LAST_UNIT },
          line.settings,
        ),
      );
    case 'line':
      if (unitId === undefined || unitId < FIRST_UNIT || unitId > LAST_UNIT) return { kind: 'impossible' };
      return scan(lineScan(unitId, transport, line.settings));
    case 'echo':
      return trials({ request, rules: { echo: 'off' } });
    case 'gap':
      return trials(
        { request, rules: { gap: LONG_SILENCE } },
        { request, rules: { gap: LONG_SILENCE, timeout: Math.max(LONG_WAIT, line.rules.timeout) } },
      );
    case 'length': {
      const half = halfOf({ request, transport });
      return half ? trials({ request: half, rules: {} }) : { kind: 'impossible' };
    }
    default:
      return { kind: 'by-hand' };
  }
}

/** The unit at the usual speeds and formats, as the line is now first. */
function lineScan(unit: number, transport: SerialMode, current: LinkSettings): ScanOrder | undefined {
  const order = scanOrder(
    {
      ...defaultScan,
      transport,
      timeout: LINE_WAIT,
      firstUnit: unit,
      lastUnit: unit,
      speeds: SPEEDS,
      formats: formatsFor(transport).slice(0, MOST_FORMATS),
    },
    current,
  );
  if (order?.what !== 'units') return undefined;
  return { ...order, lines: [current, ...order.lines.filter((line) => !isSameLine(line, current))] };
}

/** A request that reads half as much as this one reads or writes, from the same address; `undefined` if there is none. */
export function halfOf({ request, transport }: Unanswered): Uint8Array | undefined {
  const reading = decodeFrame(request, { transport, direction: 'request' });
  const { description, fields, unitId, functionCode } = reading;
  const { startAddress, quantity } = fields;
  const table = description?.table;
  if (typeof quantity !== 'number' || quantity < 2 || typeof startAddress !== 'number') return undefined;
  if (table === undefined || table === 'file-record' || functionCode === undefined) return undefined;
  return encodeFrame({
    transport,
    direction: 'request',
    unitId: unitId ?? 0,
    functionCode: accessOf(reading) === 'reads' ? functionCode : readerOf(table).code,
    fields: { startAddress, quantity: Math.floor(quantity / 2) },
  });
}

function trialsTime({ transport, trials }: TrialOrder, { settings, rules }: StepLine): number {
  return trials.reduce((sum, { request, rules: tried }) => {
    const all = { ...rules, ...tried, transport };
    const times = lineTimes(settings, all);
    return sum + times.characters(request.length) + times.gap + all.timeout;
  }, 0);
}

/** What a scan has found about a request so far; `undefined` if that is nothing yet. */
export function scanFinding(
  { request, transport }: Unanswered,
  order: ScanOrder,
  found: readonly ScanFinding[],
  progress: Pick<ScanNews, 'done' | 'total'> | undefined,
  current: LinkSettings,
): StepFinding | undefined {
  if (order.what !== 'units') return undefined;
  const { unitId = 0 } = decodeFrame(request, { transport, direction: 'request' });
  const answered = found.flatMap((one) => (one.what === 'unit' ? [one] : []));
  const isDone = progress !== undefined && progress.done === progress.total;
  if (order.lines.length > 0) {
    const best = answered.find(({ outcome }) => outcome !== 'broken');
    if (best) return { code: 'line-answers', settings: best.settings, current: isSameLine(best.settings, current) };
    const notOpened = found.filter(({ what }) => what === 'not-opened').length;
    return isDone ? { code: 'lines-silent', tried: order.lines.length, notOpened } : undefined;
  }
  const units = [...new Set(answered.map(({ unit }) => unit))];
  if (units.includes(unitId)) return { code: 'unit-answers', unit: unitId };
  if (units.length > 0) return { code: 'others-answer', unit: unitId, units };
  return isDone ? { code: 'none-answers', asked: order.last - order.first + 1 } : undefined;
}

/** What the trials of a step have found; `undefined` if none has ended. */
export function trialFinding(step: NoAnswerStep, news: readonly TrialNews[]): StepFinding | undefined {
  const answer = news.find(({ outcome }) => outcome === 'reply' || outcome === 'exception');
  if (step === 'echo' && news.some(({ returned }) => returned)) return { code: 'returned' };
  if (answer) {
    if (step === 'echo') return { code: 'answered', trial: 'no-echo' };
    if (step === 'length') return { code: 'answered', trial: 'half' };
    return { code: 'answered', trial: answer.index === 0 ? 'silence-before' : 'wait-longer' };
  }
  if (news.length === 0) return undefined;
  return { code: step === 'echo' ? 'nothing-returned' : 'still-silent' };
}

const states: Readonly<Record<StepFinding['code'], StepState>> = {
  'unit-answers': 'excluded',
  'others-answer': 'found',
  'none-answers': 'excluded',
  'line-answers': 'found',
  'lines-silent': 'excluded',
  returned: 'excluded',
  'nothing-returned': 'excluded',
  answered: 'found',
  'still-silent': 'excluded',
  stopped: 'open',
  checked: 'excluded',
  'ruled-out': 'excluded',
};

const stateOf = (finding: StepFinding): StepState =>
  finding.code === 'line-answers' && finding.current ? 'excluded' : states[finding.code];

/** The steps that what one has found rules out. */
function ruledOutBy({ code }: StepFinding): readonly NoAnswerStep[] {
  switch (code) {
    // The device answers on this line.
    case 'unit-answers':
    case 'answered':
      return ['unit', 'line', 'echo', 'wires', 'termination', 'power'];
    // The line is good, as far as the devices that answer.
    case 'others-answer':
      return ['echo', 'termination'];
    case 'line-answers':
      return ['unit', 'echo', 'wires', 'termination', 'power'];
    default:
      return [];
  }
}

/** How each step stands, by what was found. */
export function stepMarks(
  findings: ReadonlyMap<NoAnswerStep, StepFinding>,
  running: NoAnswerStep | undefined,
): ReadonlyMap<NoAnswerStep, StepMark> {
  const marks = new Map<NoAnswerStep, StepMark>();
  for (const step of noAnswerSteps) {
    const finding = findings.get(step);
    const by = finding ? undefined : noAnswerSteps.find((other) => isRuledOut(step, findings.get(other)));
    if (step === running) marks.set(step, { state: 'running', finding });
    else if (finding) marks.set(step, { state: stateOf(finding), finding });
    else marks.set(step, by ? { state: 'excluded', finding: { code: 'ruled-out', by } } : { state: 'open' });
  }
  return marks;
}

const isRuledOut = (step: NoAnswerStep, finding: StepFinding | undefined): boolean =>
  finding !== undefined && ruledOutBy(finding).includes(step);
