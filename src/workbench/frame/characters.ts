import type { Problem, Severity } from '../../modbus/index.ts';

/** The worst severity of some problems. */
export function worst(problems: readonly Problem[]): Severity | undefined {
  return (['error', 'warning', 'note'] as const).find((severity) =>
    problems.some((problem) => problem.severity === severity),
  );
}

/** Characters as printed; CR and LF by their names. */
export const characters = (bytes: Uint8Array): string => Array.from(bytes, character).join('');

export function character(byte: number): string {
  if (byte === 0x0d) return 'CR';
  if (byte === 0x0a) return 'LF';
  return byte > 0x20 && byte < 0x7f ? String.fromCharCode(byte) : '·';
}
