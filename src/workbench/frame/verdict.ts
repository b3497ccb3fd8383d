import type { Reading } from '../../modbus/index.ts';
import { worst } from './characters.ts';

/** What a frame is found to be, in a word. */
export type FrameVerdict = 'valid' | 'doubtful' | 'invalid' | 'wrong-checksum' | 'incomplete';

/**
 * The verdict on a frame: that its checksum is wrong is said if nothing else is. A frame with an address that may be two
 * things is doubtful until somebody has said which (`isOpen`).
 */
export function verdictOf({ outcome, problems }: Reading, isOpen = false): FrameVerdict {
  if (outcome.kind === 'short') return 'incomplete';
  const errors = problems.filter(({ severity }) => severity === 'error');
  if (errors.length > 0) return errors.every(({ code }) => code === 'checksum-wrong') ? 'wrong-checksum' : 'invalid';
  return isOpen || worst(problems) === 'warning' ? 'doubtful' : 'valid';
}
