import type { ComponentChildren } from 'preact';
import type { FoundRegister, Register } from '../../../devices/index.ts';

/** What is done with the registers of a device; they are named by their place in its list. */
export interface RegisterActs {
  /** The request for a register is the current frame; the sentence says so below its form. */
  readonly onTaken: (name: string, sentence: string) => void;
  /** Reads a register on the bus; without it, Read makes a request. */
  readonly onRead?: ((found: FoundRegister) => void) | undefined;
  readonly onKeep: (at: number, register: Register) => void;
  readonly onRemove: (at: number) => void;
}

/** A column with what was read. */
export interface ValueColumn {
  readonly name: string;
  readonly cell: (found: FoundRegister) => ComponentChildren;
}
