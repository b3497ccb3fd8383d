import type { Transport } from '../modbus/index.ts';
import type { ProgramPart } from './options.ts';
import { targets } from './targets/index.ts';

/** The kinds of targets, in the order in which they are offered, with the ids of those that belong to each. */
const groups = {
  plc: ['structured-text', 'scl', 'rockwell', 'ladder'],
  c: ['c', 'arduino'],
  pc: ['csharp', 'java', 'go', 'rust', 'python', 'javascript'],
  library: ['pymodbus', 'minimalmodbus', 'modbus-serial', 'jsmodbus', 'framewright'],
  command: ['mbpoll', 'modpoll', 'printf', 'powershell'],
} as const satisfies Readonly<Record<string, readonly string[]>>;

export type TargetGroup = keyof typeof groups;

/** What a target can be asked for. */
export interface TargetOffer {
  /** `undefined` if nobody has said where it belongs. */
  readonly group: TargetGroup | undefined;
  readonly parts: readonly ProgramPart[];
  readonly transports: readonly Transport[];
  readonly sequences: boolean;
}

/** What a target offers, by its id. A `RangeError` for an unknown one. */
export function targetOffer(target: string): TargetOffer {
  const found = targets.find(({ id }) => id === target);
  if (found === undefined) throw new RangeError(`no target ${target}`);
  const { parts, transports, sequences } = found;
  const names = Object.keys(groups) as readonly TargetGroup[];
  const group = names.find((name) => (groups[name] as readonly string[]).includes(target));
  return { group, parts, transports, sequences };
}
