import type { Layout } from './field.ts';
import type { Section } from './problem.ts';

/** The four tables of the data model (AP 4.3), and the file records of extended memory (AP 6.14). */
export type Table = 'coil' | 'discrete-input' | 'input-register' | 'holding-register' | 'file-record';

/** Each table has 65536 addresses, counted from 0 (AP 4.4). */
export const LAST_ADDRESS = 0xffff;

/** How a form groups the functions. */
export type FunctionGroup = 'bits' | 'registers' | 'files' | 'diagnostics' | 'identification' | 'other';

/** Everything the project knows of one function code. Adding a function is adding one such value. */
export interface FunctionCode {
  readonly code: number;
  /** The specification's name. */
  readonly name: string;
  readonly section: Section;
  readonly group: FunctionGroup;
  /** The table it addresses, where it addresses one. */
  readonly table?: Table;
  /** AP marks the function "Serial Line only". */
  readonly serialOnly?: boolean;
  /** Broadcast is agreed: PI names 05, 06, 0F and 10 only (SL 2.1 says "writing commands"). */
  readonly broadcast?: boolean;
  readonly request: Layout;
  readonly response: Layout;
}

/** Checks a function's description at compile time and keeps its literal types. */
export const defineFunction = <const F extends FunctionCode>(description: F): F => description;
