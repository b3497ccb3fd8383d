import type { SerialMode } from '../modbus/index.ts';
import type { ListName, StepKind } from './sequence.ts';

/**
 * A step as typed, valid or not: the texts of its fields by name. A form and a file hold the same, so that `readSequence`
 * reads both, and what is not right yet is kept.
 */
export interface StepTexts {
  readonly kind: StepKind;
  readonly fields: Readonly<Record<string, string>>;
  /** The steps of a repetition. */
  readonly steps?: readonly StepTexts[] | undefined;
}

/** A sequence as typed, under its name. */
export interface SequenceTexts {
  readonly name: string;
  /** What it is for, and where it comes from. */
  readonly about: string;
  readonly transport: SerialMode;
  readonly steps: readonly StepTexts[];
  readonly finally: readonly StepTexts[];
}

/** The fields of each kind of step in their order, each with its text until something is typed. */
export const stepFields: { readonly [K in StepKind]: Readonly<Record<string, string>> } = {
  send: { bytes: '', onFailure: 'stop' },
  wait: { duration: '1000' },
  until: {
    unit: '1',
    table: 'holding-register',
    address: '0',
    type: 'u16',
    order: 'ABCD',
    bit: '',
    relation: '=',
    value: '0',
    interval: '100',
    timeout: '5000',
    onFailure: 'stop',
  },
  repeat: { times: '2' },
};

export const stepKinds = Object.keys(stepFields) as readonly StepKind[];

/** A new step of this kind, with these texts in place of the usual ones. */
export const newStep = (kind: StepKind, fields?: Readonly<Record<string, string>>): StepTexts => ({
  kind,
  fields: { ...stepFields[kind], ...fields },
  ...(kind === 'repeat' && { steps: [] }),
});

export const newSequence = (name: string): SequenceTexts => ({
  name,
  about: '',
  transport: 'rtu',
  steps: [],
  finally: [],
});

/** A sequence in which another list replaces one of its own. */
export const withList = (sequence: SequenceTexts, list: ListName, steps: readonly StepTexts[]): SequenceTexts => ({
  ...sequence,
  [list]: steps,
});
