import type { Transport } from '../modbus/index.ts';
import type { ProgramPart } from './options.ts';
import type { Plan, ProgramNote } from './plan.ts';
import type { WrittenFile } from './written.ts';

/** A language, library or command in which programs are written. To add a target is to add one such value to `targets/index.ts`. */
export interface Target {
  readonly id: string;
  readonly name: string;
  /** For highlighting: a name of highlight.js, or `plaintext`. */
  readonly language: string;
  /** Whether the tests run its programs, or only hold them against rules. */
  readonly proof: 'run' | 'rules';
  /** What it offers; a part that is missing is written as the nearest one, with the note `not-offered`. */
  readonly parts: readonly ProgramPart[];
  readonly transports: readonly Transport[];
  /** Whether it writes sequences. */
  readonly sequences: boolean;
  write(plan: Plan): { readonly files: readonly WrittenFile[]; readonly notes: readonly ProgramNote[] };
}
