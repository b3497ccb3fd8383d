import type { Token } from './items.ts';
import { isMixed, isProse, isQuantity, type Run } from './runs.ts';

/**
 * How sure it is that numbers are bytes. 3: nothing else stands there, or they are many, or a direction says so; 2: they
 * look like bytes; 1: they are just numbers.
 */
export type Certainty = 1 | 2 | 3;

/** Fewest numbers in a row that are more than something counted. */
const SEVERAL = 3;
/** Digits of an unbroken run that are more than a year or a date. */
const UNBROKEN = 10;
/** Digits that may be a year. */
const YEAR = 4;

interface Numbers {
  readonly tokens: readonly Token[];
  readonly runs: readonly Run[];
  /** No words stand beside them. */
  readonly alone: boolean;
  /** A direction stands right before them. */
  readonly direct: boolean;
}

/** How sure it is that these runs of one clause are bytes. */
export function certaintyOf(plain: string, { tokens, runs, alone, direct }: Numbers): Certainty {
  const [first] = tokens;
  const [best] = runs;
  if (first === undefined || best === undefined) return 1;
  if (alone) return tokens.every((token) => isProse(plain, token)) ? 1 : 3;
  if (runs.length < SEVERAL && runs.every((run) => isMixed(run) || isQuantity(run))) return 1;
  if (best.style === 'narrow') {
    if (direct && tokens.length > 1) return 3;
    const isList = tokens.length > 1 && /[[{]/.test(plain[first.start - 1] ?? '');
    const isRow = tokens.length === SEVERAL && !tokens.some(({ comma }) => comma);
    return isList || isRow || tokens.length > SEVERAL ? 2 : 1;
  }
  if (direct || tokens.length >= SEVERAL || tokens.some(({ from, to }) => to - from >= UNBROKEN)) return 3;
  // `<Buffer 3a>`.
  if (best.style === 'pairs' && best.name === 'buffer') return 3;
  return best.style === 'said' || tokens.length > 1 || first.bracket !== '' || first.to - first.from > YEAR ? 2 : 1;
}
