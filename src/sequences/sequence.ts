import type { EntityTable } from '../devices/index.ts';
import type { NumberTypeName, Order, SerialMode } from '../modbus/index.ts';

/** Frames, waits and conditions, carried out one after another. */
export interface Sequence {
  readonly transport: SerialMode;
  readonly steps: readonly Step[];
  /** Carried out when the steps have ended, in whatever way. */
  readonly finally: readonly Step[];
}

/** `stop` ends the steps, so that the finally list comes next. In that list a failure never ends anything. */
export type OnFailure = (typeof onFailures)[number];
export const onFailures = ['stop', 'go-on'] as const;

export type Relation = (typeof relations)[number];
export const relations = ['=', '≠', '<', '≤', '>', '≥'] as const;

export type Step =
  /** Sends a frame unchanged, legal or not. It fails if the frame is refused, not answered, or answered wrongly. */
  | { readonly kind: 'send'; readonly bytes: Uint8Array; readonly onFailure: OnFailure }
  /** `duration` in milliseconds. */
  | { readonly kind: 'wait'; readonly duration: number }
  | Until
  | { readonly kind: 'repeat'; readonly times: number; readonly steps: readonly Step[] };

/** Reads a value again and again until a condition holds. It fails if that takes longer than the time-out. */
export interface Until {
  readonly kind: 'until';
  readonly unit: number;
  readonly table: EntityTable;
  /** As sent, counted from 0. */
  readonly address: number;
  /** How registers are read; coils and inputs are 0 or 1. */
  readonly type: NumberTypeName;
  readonly order: Order;
  /** Only this bit of the whole number is compared, 0 the lowest; absent if all of the number is. */
  readonly bit?: number | undefined;
  readonly relation: Relation;
  readonly value: number;
  /** From one request to the next, in milliseconds. */
  readonly interval: number;
  /** From the first request on, in milliseconds. */
  readonly timeout: number;
  readonly onFailure: OnFailure;
}

export type StepKind = Step['kind'];

/** Where a step stands: `at` has its index in the list, and in each repetition around it, the outermost first. */
export interface StepPlace {
  readonly list: ListName;
  readonly at: readonly number[];
}
export type ListName = (typeof listNames)[number];
export const listNames = ['steps', 'finally'] as const;

/** A place as a text, such as `steps 0.2`, for lookup. */
export const placeKey = ({ list, at }: StepPlace): string => `${list} ${at.join('.')}`;
