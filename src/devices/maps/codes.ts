import type { Told } from './tally.ts';

/** What a file does not say, and a person is asked once for all rows. */
export const questionCodes = [
  /** Which table the registers are in. */
  'table',
  /** Whether 3 and 4 are function codes or the digits of tables. */
  'function-or-digit',
  /** Which controller has the devices that addresses name: `D100`. */
  'plc',
  /** How addresses count. */
  'counting',
  /** Whether digits without a prefix are hexadecimal. */
  'base',
  /** Whether the number of the scale multiplies or divides what is in the registers. */
  'scale',
  'order',
  'type',
  /** What a maker's own numbers of types stand for. */
  'type-codes',
  /** Whether decimals scale a whole number, or only say how it is shown. */
  'decimals',
  /** The registers of a text. */
  'text-length',
  /** The address at which a model begins. */
  'start',
] as const;
export type QuestionCode = (typeof questionCodes)[number];

export interface MapQuestion {
  readonly code: QuestionCode;
  readonly options: readonly string[];
  readonly assumed: string;
  /** The first register it is about, and what each option makes of it: `Flow: 490 → 49 °C | 4900 °C`. */
  readonly example?: string;
}

/** Why rows are not registers. */
export const mapFaultCodes = [
  'no-table',
  /** Nothing in the file is a register, and nothing says why. */
  'no-registers',
  'not-a-table',
  'unreadable',
  'too-large',
  'no-address-column',
  'address-missing',
  'address-unreadable',
  'address-outside',
  /** A number that is not written as the file writes its numbers. */
  'not-in-convention',
  /** A file of devices that was written here cannot be read; `fault` says why. */
  'own-file',
  /** A line of a table that was written here; `fault` says what is wrong. */
  'own-table',
] as const;
export type MapFaultCode = (typeof mapFaultCodes)[number];

/** What is doubtful in registers, or was left alone. */
export const mapNoticeCodes = [
  'assumed',
  'addresses-like-numbers',
  'odd-number',
  'number-grouped',
  'number-of-other-table',
  'heading',
  /** A table of the file without addresses. */
  'table-left',
  'columns-left',
  /** A row has cells beyond the header. */
  'more-cells',
  'quote-open',
  'name-missing',
  'unused',
  'table-unknown',
  'access-unknown',
  'access-not-for-table',
  'type-unknown',
  /** The name of the type says more than what was read. */
  'type-rest',
  'type-from-length',
  'length-contradicts',
  'text-length-from-next',
  'order-unknown',
  'factor-unreadable',
  'factor-from-range',
  'offset-unreadable',
  'scale-register-unknown',
  'names-rest',
  'names-twice',
  'names-as-bits',
  'range-kept',
  'address-twice',
  'overlap',
  /** As the fault of that name, but the register is imported. */
  'own-table',
  /** An address far from those of the rows before and behind. */
  'outlier',
] as const;
export type MapNoticeCode = (typeof mapNoticeCodes)[number];

export type MapFault = Told<MapFaultCode>;
export type MapNotice = Told<MapNoticeCode>;
