import type { Reading } from '../../modbus/index.ts';
import { worst } from './characters.ts';

/** What a frame is found to be, in a word. */
export type FrameVerdict = 'valid' | 'doubtful' | 'invalid' | 'wrong-checksum' | 'incomplete';

/** The verdict on a frame: that its checksum is wrong is said if nothing else is. */
export function verdictOf({ outcome, problems }: Reading): FrameVerdict {
  if (outcome.kind === 'short') return 'incomplete';
  const errors = problems.filter(({ severity }) => severity === 'error');
  if (errors.length > 0) return errors.every(({ code }) => code === 'checksum-wrong') ? 'wrong-checksum' : 'invalid';
  return worst(problems) === 'warning' ? 'doubtful' : 'valid';
}
