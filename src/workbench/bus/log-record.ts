import type { LogLine } from '../../bus/index.ts';
import { fromHex } from '../../modbus/index.ts';
import { knownOf, type TraceInput } from '../../trace/index.ts';

const NONE = new Uint8Array(0);
const REQUESTS: ReadonlySet<LogLine['kind']> = new Set(['request', 'echo']);
const MICROSECONDS = 1000;

/** Which side has spoken; `undefined` for what was heard while nobody had asked, of which its bytes tell it. */
function sideOf({ kind, direction, verdict }: LogLine): TraceInput['side'] {
  if (kind !== 'heard') return REQUESTS.has(kind) ? 'request' : 'response';
  if (verdict === undefined) return undefined;
  return direction === 'sent' ? 'request' : 'response';
}

/** A line of the bus's log as a record of its trace, with what the session knows of it. */
export function recordOfLine(line: LogLine): TraceInput {
  const { time, transport, kind, hex, verdict } = line;
  return {
    bytes: fromHex(hex) ?? NONE,
    time: Math.round(time * MICROSECONDS),
    side: sideOf(line),
    transport,
    known: knownOf(kind, verdict),
  };
}
