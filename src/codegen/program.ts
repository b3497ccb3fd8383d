import { decodeFrame, type FrameInput } from '../modbus/index.ts';
import { readingRequest, type Sequence, type Step } from '../sequences/index.ts';
import { type AskedRequest, makePlan } from './make-plan.ts';
import { type ProgramOptions, type ProgramPart, programParts } from './options.ts';
import type { ProgramNote } from './plan.ts';
import { settingsOf } from './settings.ts';
import type { Target } from './target.ts';
import { targets } from './targets/index.ts';

/** What a program is written for. */
export type ProgramSubject =
  | { readonly request: FrameInput }
  | { readonly frames: readonly { readonly name: string; readonly request: FrameInput }[] }
  | { readonly sequence: Sequence };

/** A program as it is written. */
export interface Program {
  readonly files: readonly { readonly name: string; readonly text: string }[];
  /** The lines that make or read bytes of the frame: `line` from 1, spans by name, as in a `Reading`. */
  readonly lines: readonly { readonly file: number; readonly line: number; readonly spans: readonly string[] }[];
  readonly notes: readonly ProgramNote[];
}

/** The languages, libraries and commands in which programs are written. `proof`: whether our tests run them. */
export const programTargets: readonly {
  readonly id: string;
  readonly name: string;
  readonly language: string;
  readonly proof: 'run' | 'rules';
}[] = targets.map(({ id, name, language, proof }) => ({ id, name, language, proof }));

/**
 * The program for a request, several frames or a sequence, in the language of a target (an id of `programTargets`). Throws a
 * `RangeError` for an unknown target, and for what has no bytes.
 */
export function writeProgram(target: string, what: ProgramSubject, options: ProgramOptions = {}): Program {
  const found = targets.find(({ id }) => id === target);
  if (found === undefined) throw new RangeError(`no target ${target}`);
  return writeFor(found, what, options);
}

/** The program in the language of a target that is given itself. */
export function writeFor(target: Target, what: ProgramSubject, options: ProgramOptions = {}): Program {
  const notes: ProgramNote[] = [];
  const asked = requestsOf(what, options);
  const sequence = 'sequence' in what ? what.sequence : undefined;
  const transport = asked[0]?.request.transport ?? 'rtu';
  if (sequence !== undefined && !target.sequences) notes.push({ code: 'not-offered', what: 'sequence' });
  // A sequence is written whole.
  const wanted = sequence === undefined ? (options.part ?? 'exchange') : 'exchange';
  const carried = target.transports.includes(transport);
  if (!carried) notes.push({ code: 'not-offered', what: transport });
  const part = nearestPart(carried ? wanted : 'bytes', target.parts);
  if (carried && part !== wanted) notes.push({ code: 'not-offered', what: wanted });
  const { plan, notes: planned } = makePlan(
    asked,
    settingsOf({ ...options, part }),
    target.sequences ? sequence : undefined,
  );
  const { files, notes: written } = target.write(plan);
  return {
    files: files.map(({ name, text }) => ({ name, text })),
    lines: files.flatMap(({ lines }, file) => lines.map(({ line, spans }) => ({ file, line, spans }))),
    notes: [...notes, ...planned, ...written],
  };
}

/** The part that a target offers next to the one that is wanted: rather more than less. */
function nearestPart(wanted: ProgramPart, offered: readonly ProgramPart[]): ProgramPart {
  const at = programParts.indexOf(wanted);
  const more = programParts.slice(at).find((part) => offered.includes(part));
  return more ?? programParts.slice(0, at).findLast((part) => offered.includes(part)) ?? wanted;
}

function requestsOf(what: ProgramSubject, { name }: ProgramOptions): readonly AskedRequest[] {
  if ('request' in what) return [{ name, request: what.request }];
  if ('frames' in what) return what.frames.map(({ name: own, request }) => ({ name: own, request }));
  const { transport, steps, finally: last } = what.sequence;
  const frames = [...framesOf(steps, transport), ...framesOf(last, transport)];
  const seen = new Set<string>();
  const different = frames.filter((bytes) => !seen.has(String(bytes)) && seen.add(String(bytes)));
  return different.map((bytes) => ({ name: undefined, request: inputOf(bytes, transport) }));
}

/** The frames that steps send, in their order, and those that conditions read with. */
const framesOf = (steps: readonly Step[], transport: Sequence['transport']): readonly Uint8Array[] =>
  steps.flatMap((step) => {
    if (step.kind === 'repeat') return framesOf(step.steps, transport);
    if (step.kind === 'send') return [step.bytes];
    return step.kind === 'until' ? [readingRequest(step, transport)] : [];
  });

/** A frame as the encoder takes it, so that it writes the same bytes. */
function inputOf(bytes: Uint8Array, transport: Sequence['transport']): FrameInput {
  const { unitId, functionCode, fields, forced } = decodeFrame(bytes, { transport, direction: 'request' });
  return { transport, direction: 'request', unitId, functionCode, fields, force: forced };
}
