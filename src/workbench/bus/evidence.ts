import {
  fits,
  isSameLine,
  type LinkSettings,
  type ScanAnswer,
  type ScanFinding,
  type ScanNews,
  type ScanOrder,
  type TrialNews,
} from '../../bus/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import { type NoAnswerStep, noAnswerSteps, type Unanswered } from './no-answer.ts';

/** What was observed in a step. */
export type StepFinding =
  | { readonly code: 'unit-answers'; readonly unit: number }
  | { readonly code: 'others-answer'; readonly unit: number; readonly units: readonly number[] }
  | { readonly code: 'none-answers'; readonly asked: number }
  /** The unit answers on the line as it is. */
  | { readonly code: 'line-answers'; readonly settings: LinkSettings }
  | { readonly code: 'other-line-answers'; readonly settings: LinkSettings }
  | { readonly code: 'lines-silent'; readonly tried: number; readonly notOpened: number }
  /** The request came back, so that it was sent; and nothing else came. */
  | { readonly code: 'returned' }
  /** What came back is the request and may be its reply too, because the two have the same bytes. */
  | { readonly code: 'returned-as-reply' }
  /** It came back, and its reply behind it. */
  | { readonly code: 'answers-behind-echo' }
  | { readonly code: 'nothing-returned' }
  /** The device answered when no echo was removed; behind a longer silence; when it was waited for; half the request. */
  | { readonly code: 'answers-unfiltered' }
  | { readonly code: 'answers-after-silence' }
  | { readonly code: 'answers-late' }
  | { readonly code: 'answers-half' }
  | { readonly code: 'still-silent' }
  /** Something came that is not a sound reply. */
  | { readonly code: 'garbled' }
  /** A gateway answers that the device behind it does not. */
  | { readonly code: 'gateway-answers' }
  /** It was ended before it had found anything. */
  | { readonly code: 'stopped'; readonly done: number; readonly total: number }
  /** Somebody has looked at it. */
  | { readonly code: 'checked' }
  /** What another step has found rules it out. */
  | { readonly code: 'ruled-out'; readonly by: NoAnswerStep };

/** `tried`: what came of it decides nothing; `excluded`: this is not why; `found`: it is, or it is near. */
export type StepState = 'open' | 'running' | 'tried' | 'excluded' | 'found';

export interface StepMark {
  readonly state: StepState;
  readonly finding?: StepFinding | undefined;
}

interface Evidence {
  /** What it says of the step in which it was observed. */
  readonly own: StepState;
  /** The other steps that it excludes. */
  readonly excludes?: readonly NoAnswerStep[];
  /** Another request was answered than the one that it is about. */
  readonly byAnother?: true;
}

/** The device itself was heard on this line: it is there, and its two wires are right. */
const HEARD = ['unit', 'wires', 'power'] as const;

/**
 * What each observation is evidence of. Silence excludes nothing: any other cause may be behind it. A short reply says
 * nothing of the termination, whose lack hurts long frames and fast lines first.
 */
const evidence: Readonly<Record<Exclude<StepFinding['code'], 'ruled-out'>, Evidence>> = {
  'unit-answers': { own: 'excluded', excludes: [...HEARD, 'line', 'echo'], byAnother: true },
  // Their wires and their speed are right: those of the unit that is silent may not be.
  'others-answer': { own: 'found', excludes: ['echo'], byAnother: true },
  'none-answers': { own: 'tried' },
  'line-answers': { own: 'excluded', excludes: [...HEARD, 'echo'], byAnother: true },
  'other-line-answers': { own: 'found', excludes: [...HEARD, 'echo'], byAnother: true },
  'lines-silent': { own: 'tried' },
  returned: { own: 'excluded' },
  'returned-as-reply': { own: 'tried' },
  'nothing-returned': { own: 'tried' },
  // The same request is answered, with the same silence before it.
  'answers-behind-echo': { own: 'excluded', excludes: [...HEARD, 'line', 'gap', 'length'] },
  'answers-unfiltered': { own: 'found', excludes: [...HEARD, 'line', 'gap', 'length'] },
  'answers-after-silence': { own: 'found', excludes: [...HEARD, 'line', 'echo', 'length'] },
  'answers-late': { own: 'found', excludes: [...HEARD, 'line', 'echo', 'length'] },
  // Gaps between its bytes hurt a long request, and spare a short one.
  'answers-half': { own: 'found', excludes: [...HEARD, 'line', 'echo'], byAnother: true },
  'still-silent': { own: 'tried' },
  garbled: { own: 'tried' },
  'gateway-answers': { own: 'tried' },
  stopped: { own: 'open' },
  checked: { own: 'excluded' },
};

const evidenceOf = ({ code }: StepFinding): Evidence => (code === 'ruled-out' ? { own: 'excluded' } : evidence[code]);

/** How each step stands, by what was observed about a request. */
export function stepMarks(
  findings: ReadonlyMap<NoAnswerStep, StepFinding>,
  running: NoAnswerStep | undefined,
  about: Unanswered | undefined,
): ReadonlyMap<NoAnswerStep, StepMark> {
  // What is removed as an echo may be its reply, which says nothing of a reply with other bytes.
  const mayHide = about !== undefined && isItsOwnReply(about);
  const excludes = (other: NoAnswerStep, step: NoAnswerStep): boolean => {
    const finding = findings.get(other);
    if (finding === undefined || other === step) return false;
    const { excludes = [], byAnother } = evidenceOf(finding);
    return excludes.includes(step) && !(step === 'echo' && byAnother && mayHide);
  };
  const markOf = (step: NoAnswerStep): StepMark => {
    const finding = findings.get(step);
    if (step === running) return { state: 'running', finding };
    const { own } = finding ? evidenceOf(finding) : { own: 'open' as const };
    if (own !== 'open' && own !== 'tried') return { state: own, finding };
    const by = noAnswerSteps.find((other) => excludes(other, step));
    if (by) return { state: 'excluded', finding: { code: 'ruled-out', by } };
    return finding ? { state: own, finding } : { state: 'open' };
  };
  return new Map(noAnswerSteps.map((step) => [step, markOf(step)]));
}

/** Whether the reply to a request has the same bytes as the request, as those to 05, 06 and most of 08. */
const isItsOwnReply = ({ request, transport }: Unanswered): boolean => fits(request, { transport, request });

const GATEWAY_CODES = [0x0a, 0x0b];

/** Who has answered, if anybody has (AP 7). */
function whoAnswers({
  outcome,
  exceptionCode,
}: {
  readonly outcome: ScanAnswer['outcome'] | TrialNews['outcome'];
  readonly exceptionCode?: number;
}) {
  if (outcome === 'broken') return 'garbled';
  if (outcome === 'reply') return 'device';
  if (outcome !== 'exception') return undefined;
  return exceptionCode !== undefined && GATEWAY_CODES.includes(exceptionCode) ? 'gateway-answers' : 'device';
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
  const all = found.flatMap((one) => (one.what === 'unit' ? [{ ...one, by: whoAnswers(one) }] : []));
  const answered = all.filter(({ by }) => by === 'device');
  const isDone = progress !== undefined && progress.done === progress.total;
  const others = (['garbled', 'gateway-answers'] as const).find((code) => all.some(({ by }) => by === code));
  if (order.lines.length > 0) {
    const [best] = answered;
    if (best) {
      const { settings } = best;
      return { code: isSameLine(settings, current) ? 'line-answers' : 'other-line-answers', settings };
    }
    if (!isDone) return undefined;
    if (others === 'gateway-answers') return { code: others };
    const notOpened = found.filter(({ what }) => what === 'not-opened').length;
    return { code: 'lines-silent', tried: order.lines.length, notOpened };
  }
  const units = [...new Set(answered.map(({ unit }) => unit))];
  if (units.includes(unitId)) return { code: 'unit-answers', unit: unitId };
  if (units.length > 0) return { code: 'others-answer', unit: unitId, units };
  if (!isDone) return undefined;
  return others ? { code: others } : { code: 'none-answers', asked: order.last - order.first + 1 };
}

/** What the trials of a step about a request have found; `undefined` if none has ended. */
export function trialFinding(
  step: NoAnswerStep,
  about: Unanswered,
  news: readonly TrialNews[],
): StepFinding | undefined {
  const answer = news.find((one) => whoAnswers(one) === 'device');
  if (step === 'echo' && news.some(({ returned }) => returned))
    return { code: isItsOwnReply(about) ? 'returned-as-reply' : answer ? 'answers-behind-echo' : 'returned' };
  if (answer) {
    if (step === 'echo') return { code: 'answers-unfiltered' };
    if (step === 'length') return { code: 'answers-half' };
    return { code: answer.index === 0 ? 'answers-after-silence' : 'answers-late' };
  }
  if (news.length === 0) return undefined;
  for (const code of ['garbled', 'gateway-answers'] as const)
    if (news.some((one) => whoAnswers(one) === code)) return { code };
  return { code: step === 'echo' ? 'nothing-returned' : 'still-silent' };
}
