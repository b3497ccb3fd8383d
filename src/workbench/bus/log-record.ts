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

/**
 * The lines of the bus's log as records of its trace, with what the session knows of them. Their bytes lie in one memory, which a message
 * has once.
 */
export function recordsOfLines(lines: readonly LogLine[]): TraceInput[] {
  const all = fromHex(lines.map(({ hex }) => hex).join('')) ?? NONE;
  let end = 0;
  return lines.map((line) => {
    const { time, transport, kind, hex, verdict } = line;
    const from = end;
    end += hex.length / 2;
    return {
      bytes: all.subarray(from, end),
      time: Math.round(time * MICROSECONDS),
      side: sideOf(line),
      transport,
      known: knownOf(kind, verdict),
    };
  });
}
