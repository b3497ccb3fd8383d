import { describeFunction } from './functions/index.ts';
import { rawFunction } from './functions/raw.ts';
import type { Fault } from './problem.ts';

/** Codes AP Annex A reserves for companies' legacy products; PI lists some of them by name. */
const RESERVED = [9, 10, 13, 14, 41, 42, 90, 91, 125, 126, 127] as const;

/** Whose protocol is known to use a code that the specification leaves to others. */
const VENDORS: Readonly<Record<number, string>> = {
  9: 'Program 484 (PI)',
  10: 'Poll 484 (PI)',
  13: 'Program Controller (PI)',
  14: 'Poll Controller (PI)',
  70: 'Fast Modbus (Wiren Board)',
  90: 'UMAS (Schneider Electric)',
};

/** How the specification sees a function code. */
export type CodeRange = 'public' | 'user-defined' | 'reserved' | 'unassigned' | 'zero' | 'exception';

/** The range a function code lies in (AP 4.1, AP 5, AP Annex A). */
export function codeRange(code: number): CodeRange {
  if (code === 0) return 'zero';
  if (code > 127) return 'exception';
  if (describeFunction(code, 'request') !== rawFunction) return 'public';
  if ((code >= 65 && code <= 72) || (code >= 100 && code <= 110)) return 'user-defined';
  return RESERVED.some((reserved) => reserved === code) ? 'reserved' : 'unassigned';
}

/** Whose protocol is known to use this code; `undefined` if no one's is. */
export const vendorOf = (code: number): string | undefined => VENDORS[code];

/** What is wrong with, or noteworthy about, a function code by itself; for a reply, `code` without the exception bit. */
export const codeFault = (code: number): Fault | undefined => FAULTS[code];

function faultOf(code: number): Fault | undefined {
  switch (codeRange(code)) {
    case 'public':
      return undefined;
    case 'zero':
      return { code: 'function-zero', severity: 'error', section: 'AP 4.1' };
    case 'exception':
      return { code: 'function-above-127', severity: 'error', got: code, section: 'AP 4.1' };
    case 'user-defined':
      return { code: 'function-user-defined', severity: 'note', got: code, vendor: vendorOf(code), section: 'AP 5' };
    case 'reserved':
      return {
        code: 'function-reserved',
        severity: 'warning',
        got: code,
        vendor: vendorOf(code),
        section: 'AP Annex A',
      };
    case 'unassigned':
      return { code: 'function-unassigned', severity: 'warning', got: code, section: 'AP 5' };
  }
}

const FAULTS = Array.from({ length: 256 }, (_, code) => faultOf(code));
