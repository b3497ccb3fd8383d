import type { Table } from './address.ts';
import type { Layout, Values } from './field.ts';
import type { Section } from './problem.ts';

/** How a form groups the functions. */
export type FunctionGroup = 'bits' | 'registers' | 'files' | 'diagnostics' | 'identification' | 'other';

/** What a request does to a device. `reads-and-writes`: each at an address of its own. */
export type FunctionAccess = 'reads' | 'writes' | 'reads-and-writes';

/** The value of a field decides what a request does. With any value that is not listed it may change the device. */
export interface AccessChoice {
  readonly by: string;
  readonly reads: readonly number[];
}

interface Described {
  readonly code: number;
  /** The specification's name. */
  readonly name: string;
  readonly section: Section;
  readonly group: FunctionGroup;
  /** AP marks the function "Serial Line only". */
  readonly serialOnly?: boolean;
  /** Broadcast is agreed: PI names 05, 06, 0F and 10 only (SL 2.1 says "writing commands"). */
  readonly broadcast?: boolean;
  readonly request: Layout;
  readonly response: Layout;
}

/**
 * The table that the function addresses, if it addresses one, and how many elements a request is about: `one` at an address,
 * `many` from an address on, by a quantity, or `other` (a queue, groups of records, some bits of a register).
 */
type Place =
  | { readonly table: Table; readonly items: 'one' | 'many' | 'other' }
  | { readonly table?: undefined; readonly items?: undefined };

/** What a request does. One that only reads is probed: `probe` has the fields of a request as harmless as possible. */
type Doing =
  | { readonly access: 'reads' | AccessChoice; readonly probe: Values }
  | { readonly access: 'writes' | 'reads-and-writes'; readonly probe?: undefined };

/** Everything the project knows about one function code. To add a function is to add one such value. */
export type FunctionCode = Described & Place & Doing;

/** Checks a function's description at compile time and keeps its literal types. */
export const defineFunction = <const F extends FunctionCode>(description: F): F => description;
