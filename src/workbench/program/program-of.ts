import {
  type Program,
  type ProgramOptions,
  type ProgramPart,
  type ProgramSubject,
  programTargets,
  type TargetGroup,
  targetOffer,
  writeProgram,
} from '../../codegen/index.ts';
import { decodeFrame, type FrameInput, type Reading, type Transport } from '../../modbus/index.ts';
import type { Sequence, Step } from '../../sequences/index.ts';
import type { Draft } from '../frame/draft.ts';
import { type Evaluation, evaluate, requestOf } from '../frame/evaluate.ts';

/** Why there is no program of what is shown. */
export type NoProgram = 'no-frame' | 'no-request' | 'broken' | 'mixed' | 'no-requests' | 'nothing-sent';

/** What a program is to be written for, or why it cannot be. */
export type ProgramFor =
  | { readonly kind: 'subject'; readonly subject: ProgramSubject; readonly transport: Transport }
  | { readonly kind: 'none'; readonly why: NoProgram };

const none = (why: NoProgram): ProgramFor => ({ kind: 'none', why });

/** A request as it was read, so that its bytes are written again. */
const inputOf = ({ transport, unitId, functionCode, transactionId, fields, forced }: Reading): FrameInput => ({
  transport,
  direction: 'request',
  unitId,
  functionCode,
  transactionId,
  fields,
  force: forced,
});

/** The request that a program is about: the frame itself, or what it answers. */
function requestFor(draft: Draft, frame: Evaluation['frame']): FrameInput | NoProgram {
  if (frame === undefined) return 'no-frame';
  const { reading } = frame;
  if (reading.direction === 'request') return reading.outcome.kind === 'whole' ? inputOf(reading) : 'broken';
  const request = requestOf(draft);
  if (request === undefined) return 'no-request';
  const asked = decodeFrame(request, { transport: reading.transport, direction: 'request' });
  return asked.outcome.kind === 'whole' ? inputOf(asked) : 'broken';
}

/** The program of a frame: of a reply it is that of the request. */
export function programForFrame(draft: Draft, frame: Evaluation['frame']): ProgramFor {
  const request = requestFor(draft, frame);
  return typeof request === 'string'
    ? none(request)
    : { kind: 'subject', subject: { request }, transport: request.transport };
}

/** One program of several frames under their names; of replies those of their requests. All are sent on one transport. */
export function programForFrames(drafts: readonly { readonly name: string; readonly draft: Draft }[]): ProgramFor {
  const frames = drafts.flatMap(({ name, draft }) => {
    const request = requestFor(draft, evaluate(draft).frame);
    return typeof request === 'string' ? [] : [{ name, request }];
  });
  const [first] = frames;
  if (first === undefined || frames.length < drafts.length) return none('no-requests');
  const { transport } = first.request;
  if (frames.some(({ request }) => request.transport !== transport)) return none('mixed');
  return { kind: 'subject', subject: { frames }, transport };
}

/** The program of a sequence; `undefined` stands for one with faults. */
export const programForSequence = (sequence: Sequence | undefined): ProgramFor =>
  sequence && sends([...sequence.steps, ...sequence.finally])
    ? { kind: 'subject', subject: { sequence }, transport: sequence.transport }
    : none('nothing-sent');

const sends = (steps: readonly Step[]): boolean =>
  steps.some((step) => step.kind === 'send' || step.kind === 'until' || (step.kind === 'repeat' && sends(step.steps)));

/** A target as it is offered: `able` if it can write what is wanted and more than its bytes. */
export interface OfferedTarget {
  readonly id: string;
  readonly name: string;
  readonly language: string;
  readonly proof: 'run' | 'rules';
  readonly group: TargetGroup | undefined;
  readonly able: boolean;
}

/** Every target, in the order in which they are offered, with whether it can write a program for what is sent like this. */
export const offeredTargets = (transport: Transport, sequence: boolean): readonly OfferedTarget[] =>
  programTargets.map((target) => {
    const { group, transports, sequences } = targetOffer(target.id);
    return { ...target, group, able: transports.includes(transport) && (sequences || !sequence) };
  });

/** The parts of a program that a target offers. Of a sequence there is one program, whole. */
export const offeredParts = (target: string, sequence: boolean): readonly ProgramPart[] =>
  sequence ? ['exchange'] : targetOffer(target).parts;

/** A program, or `undefined` if what is wanted has no bytes after all. */
export function writtenProgram(target: string, subject: ProgramSubject, options: ProgramOptions): Program | undefined {
  try {
    return writeProgram(target, subject, options);
  } catch (error) {
    if (error instanceof RangeError) return undefined;
    throw error;
  }
}

/** The files of programs of all targets that offer what is wanted, each target in a folder of its own. */
export function allPrograms(
  { subject, transport }: Extract<ProgramFor, { kind: 'subject' }>,
  options: ProgramOptions,
): readonly { readonly path: string; readonly text: string }[] {
  return offeredTargets(transport, 'sequence' in subject)
    .filter(({ able }) => able)
    .flatMap(({ id }) =>
      (writtenProgram(id, subject, options)?.files ?? []).map(({ name, text }) => ({ path: `${id}/${name}`, text })),
    );
}
