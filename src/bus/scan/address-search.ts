import type { Block } from './order.ts';
import type { ScanAnswer } from './scan-news.ts';

/** A device refuses a block of which it lacks an address (02), or that is longer than it gives at once (03). */
const LACKS_ADDRESS = 0x02;
const TOO_LONG = 0x03;
/** Some devices answer that they failed (04) when an address is missing. */
const FAILED = 0x04;
const HALVED: ReadonlySet<number | undefined> = new Set([LACKS_ADDRESS, TOO_LONG, FAILED]);

export interface SearchParts {
  readonly first: number;
  readonly last: number;
  readonly most: number;
  readonly least: number;
  /** `undefined` ends the search. */
  readonly ask: (block: Block) => Promise<ScanAnswer | undefined>;
  /** Called in the order of the addresses, each of them once. */
  readonly tell: (block: Block, answer: ScanAnswer) => void;
}

/** Finds the addresses that answer: a block that is refused is halved until its parts answer, or are small enough. */
export async function searchAddresses({ first, last, least, ask, tell, ...limits }: SearchParts): Promise<void> {
  let { most } = limits;
  let over = false;

  /** Whether the block was answered as a whole. `known` is its answer, if that is certain without asking. */
  const search = async (block: Block, known?: ScanAnswer): Promise<boolean> => {
    const answer = known ?? (over ? undefined : await ask(block));
    if (answer === undefined || over) {
      over = true;
      return false;
    }
    const { address, quantity } = block;
    if (!HALVED.has(answer.exceptionCode) || quantity <= least) {
      tell(block, answer);
      return answer.outcome === 'reply';
    }
    const half = Math.ceil(quantity / 2);
    const isFirst = await search({ address, quantity: half });
    if (isFirst && answer.exceptionCode === TOO_LONG) most = Math.min(most, half);
    // If the first half answers, the missing address is in the second.
    const sure = isFirst && answer.exceptionCode === LACKS_ADDRESS ? answer : undefined;
    await search({ address: address + half, quantity: quantity - half }, sure);
    return false;
  };

  for (let address = first; address <= last && !over; ) {
    const quantity = Math.min(most, last - address + 1);
    await search({ address, quantity });
    address += quantity;
  }
}
