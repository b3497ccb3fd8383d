import { sameBytes, type Transport } from '../modbus/index.ts';
import { readingRequest, type Step, type Until } from '../sequences/index.ts';
import type { Name, Routine } from './code.ts';
import type { PlannedRequest, PlannedStep } from './plan.ts';
import { envelopes } from './routines/envelope.ts';
import { holdsRoutine } from './routines/holds.ts';

/** What steps are planned with. */
export interface StepContext {
  readonly requests: readonly PlannedRequest[];
  readonly transport: Transport;
  /** A name that nobody has. */
  readonly free: (wanted: Name) => Name;
  readonly add: (routine: Routine) => void;
}

const RELATIONS: Readonly<Record<Until['relation'], string>> = {
  '=': 'equal to',
  '≠': 'not equal to',
  '<': 'less than',
  '≤': 'at most',
  '>': 'greater than',
  '≥': 'at least',
};

/** Steps of a sequence with the requests that they send and read with, and a routine for each condition. */
export const plannedSteps = (steps: readonly Step[], context: StepContext): readonly PlannedStep[] =>
  steps.map((step) => plannedStep(step, context));

function plannedStep(step: Step, context: StepContext): PlannedStep {
  switch (step.kind) {
    case 'send': {
      const request = requestOf(step.bytes, context);
      return { kind: 'send', about: request.about, request, stops: step.onFailure === 'stop' };
    }
    case 'wait':
      return { kind: 'wait', about: `Wait ${step.duration} ms`, duration: step.duration };
    case 'repeat': {
      const { times, steps } = step;
      return { kind: 'repeat', about: `Repeat ${times} times`, times, steps: plannedSteps(steps, context) };
    }
    case 'until':
      return plannedUntil(step, context);
  }
}

function requestOf(bytes: Uint8Array, { requests }: StepContext): PlannedRequest {
  const found = requests.find((one) => sameBytes(one.bytes, bytes));
  if (found === undefined) throw new TypeError('a step whose request is not planned');
  return found;
}

function plannedUntil(step: Until, context: StepContext): PlannedStep {
  const { relation, value, bit, interval, timeout, onFailure } = step;
  const { transport, free, add } = context;
  const request = requestOf(readingRequest(step, transport === 'ascii' ? 'ascii' : 'rtu'), context);
  const condition = `${bit === undefined ? 'the value' : `bit ${bit}`} is ${RELATIONS[relation]} ${value}`;
  const holds = free(`${request.name} holds`);
  add(holdsRoutine(step, request.reading, envelopes[transport], holds, `Whether ${condition}.`));
  const about = `Read until ${condition}: ${request.about}`;
  return { kind: 'until', about, request, holds, interval, timeout, stops: onFailure === 'stop' };
}
