import { MOST_ASCII } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import { tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, join } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const COST = 2;
const CARRIED = ['rtu', 'tcp', 'ascii'] as const;

/** One frame came in pieces: these bytes and their neighbours make it together. */
export const fragments: Hypothesis = {
  codes: ['fragments'],
  offer: (item) => {
    const joins = joinsAround(item);
    return joins.flatMap(({ joined, lines }): Offer[] => {
      const bits = CARRIED.flatMap((transport) =>
        item.transport === undefined || item.transport === transport ? wholesOf(joined, transport, item.request) : [],
      )
        .filter(({ reading }) => !hasErrors(reading))
        .map((whole) => whole.bits);
      if (bits.length === 0) return [];
      const sure = Math.max(...bits) - tries(joins.length) - COST;
      return [{ code: 'fragments', from: 0, to: item.bytes.length, lines, repaired: [joined], bits: sure }];
    });
  },
};

/** The bytes with the pieces next to them, as many as a frame can have. */
function joinsAround({ bytes, preceding, following, cut }: Case): { joined: Uint8Array; lines: number }[] {
  const joins: { joined: Uint8Array; lines: number }[] = [];
  if (cut) return joins;
  for (let before = 0; before <= preceding.length; before++) {
    for (let after = 0; after <= following.length; after++) {
      if (before + after === 0) continue;
      const pieces = [...preceding.slice(preceding.length - before), bytes, ...following.slice(0, after)];
      if (pieces.reduce((sum, { length }) => sum + length, 0) > MOST_ASCII) break;
      joins.push({ joined: join(...pieces), lines: pieces.length });
    }
  }
  return joins;
}
