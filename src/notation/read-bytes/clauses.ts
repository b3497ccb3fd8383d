import { type Item, isNumber, isToken, type Mark, Token } from './items.ts';
import { CHECKSUM, isEnglish, OLD, type Run, run, withoutProse } from './runs.ts';
import { partyOf } from './sides.ts';
import type { ChunkLabel } from './types.ts';

/** The part of a line that one direction governs. */
export interface Clause {
  readonly label: ChunkLabel;
  readonly runs: readonly Run[];
  /** The items that are bytes only if nothing else is. */
  readonly first: Token | undefined;
  /** Nothing but numbers and what is known around them stands there. */
  readonly alone: boolean;
  /** A direction stands right before the numbers. */
  readonly direct: boolean;
  /** What its words say of its numbers. */
  readonly hint: Hint;
  /** The arrow before its numbers, which says a direction only if others point the other way. */
  readonly arrow: ChunkLabel['direction'];
}

/** `again`: a program says what it has just received; `total`: all of a buffer so far. */
export type Hint = 'again' | 'total' | undefined;

/** The label of what nothing is said of. */
export const NO_LABEL: ChunkLabel = Object.freeze({});
const LONGEST_NAME = 24;
/** The most characters an oddity may have and still be a misspelt byte. */
const ODDITY = 4;
/** Fewest bytes behind a direction that are bytes, whatever follows them. */
const SEVERAL = 3;
const CLOCK_TIME = /\d[:T]\d|\d[-_ ]\d/;
/** Characters of a time of day without fractions. */
const CLOCK = 8;
/** What is said to be sent: `TX data: 11`. */
const OF_BYTES = /^(?:data|bytes|frame|adu|hex)$/;
/** Who sends and receives. */
const SPEAKER = /^(?:master|client|slave|server)$/;
/** Names of what counts bytes. */
const COUNT = /^(?:len|length|size|no|num)$/;
const AGAIN =
  /^(?:process(?:ing|ed)|handling|getting|mb_send|mb_recv|parsing|parsed|decod(?:ing|ed)|validat(?:ing|ed)|emit|payload|raw|dump)$/;
const TOTAL = /^(?:buf|buff|buffer|buffered|accumulated|cumulative|total|sofar|far)$/;

/** Gathers the items of one line into clauses. */
export function clausesOf(plain: string, items: readonly Item[]): readonly Clause[] {
  if (items.every(isNumber)) return plainClause(plain, items);
  const builder = new Builder(plain);
  for (const item of settled(plain, items)) builder.take(item);
  return builder.end();
}

/** A line of nothing but numbers. */
function plainClause(plain: string, items: readonly Token[]): readonly Clause[] {
  const tokens = withoutProse(plain, items);
  const said = { inParentheses: false, isName: false, isNamed: false, name: '' };
  const alone = tokens.length === items.length;
  const runs = [run(plain, tokens, said)];
  return [{ label: NO_LABEL, runs, first: items[0], alone, direct: false, hint: undefined, arrow: undefined }];
}

/** Numbers that are words beside other words, words that are misspelt bytes between numbers, and times that are bytes. */
function settled(plain: string, items: readonly Item[]): readonly Item[] {
  const list = timeAsBytes(plain, items);
  for (const [index, item] of list.entries()) {
    const before = list[index - 1];
    if (isNumber(item)) {
      const isBehind = before?.kind === 'word' && item.start - before.end === 1 && isEnglish(plain, item);
      const isWord = isBehind && !/buffer$/i.test(plain.slice(before.start, before.end));
      if (isWord && (isSmall(plain, item) || !isNumber(list[index + 1]))) list[index] = asWord(item);
    } else if (item.kind === 'oddity') list[index] = misspelt(plain, item, before, list[index + 1]);
  }
  for (let index = list.length - 2; index >= 0; index--) {
    const [item, behind] = [list[index], list[index + 1]];
    if (!isNumber(item) || behind?.kind !== 'word' || behind.start - item.end !== 1 || !isEnglish(plain, item))
      continue;
    // A pair among others is a byte all the same.
    if (!isNumber(list[index - 1]) || (item.to - item.from) % 2 !== 0) list[index] = asWord(item);
  }
  return list;
}

const isSmall = (plain: string, { from }: Token) => plain.charCodeAt(from) >= 0x61;
const asWord = ({ start, end }: Item): Mark => ({ kind: 'word', start, end });

/** What looks like a time of day is three bytes if it is all there is in the line, or all behind its direction. */
function timeAsBytes(plain: string, items: readonly Item[]): Item[] {
  const list = [...items];
  const at = list.findLastIndex(({ kind }) => kind !== 'close' && kind !== 'label');
  const [item, before] = [list[at], list[at - 1]];
  if (item?.kind !== 'time' || item.end - item.start > CLOCK) return list;
  const isFirst = list.slice(0, at).every(({ kind }) => kind === 'open');
  const isBehind = before?.kind === 'side' && before.says?.direction !== undefined;
  if ((!isFirst && !isBehind) || plain[item.start - 1] === '[') return list;
  const pairs = Array.from(plain.slice(item.start, item.end).matchAll(/\d+/g), ({ 0: digits, index }) => {
    const start = item.start + index;
    return new Token('number', start, start + digits.length, start, start + digits.length, 0);
  });
  list.splice(at, 1, ...pairs);
  return list;
}

function misspelt(plain: string, { start, end }: Item, before: Item | undefined, behind: Item | undefined): Item {
  const hasDigit = /\d/.test(plain.slice(start, Math.min(end, start + ODDITY)));
  const isBetween = isNumber(behind) && (isToken(before) || hasDigit);
  const isAtEnd = isToken(before) && hasDigit;
  if (end - start > ODDITY || !(isBetween || isAtEnd)) return { kind: 'word', start, end };
  return new Token('not-a-byte', start, end, start, end, 0);
}

class Builder {
  readonly #plain: string;
  readonly #clauses: Clause[] = [];
  #label: ChunkLabel = NO_LABEL;
  #arrow: ChunkLabel['direction'];
  #runs: Run[] = [];
  #row: Token[] = [];
  #first: Token | undefined;
  #begun = false;
  #words = 0;
  #direct = false;
  /** How many bytes have followed right behind a direction. */
  #followed = 0;
  #hint: Hint;
  #name = '';
  /** Where that name ends. */
  #nameEnd = -1;
  #isNamed = false;
  #parentheses = 0;

  constructor(plain: string) {
    this.#plain = plain;
  }

  take(item: Item): void {
    if (isToken(item)) this.#number(item);
    else if (item.kind === 'word') this.#word(item);
    else if (item.kind === 'side') this.#side(item);
    else if (item.kind === 'label') this.#colon();
    else if (item.kind === 'open' || item.kind === 'close') this.#bracket(item);
    else {
      this.#begun = true;
      this.#endRow();
      if (item.kind === 'time') this.#time(this.#plain.slice(item.start, item.end));
    }
  }

  end(): readonly Clause[] {
    this.#endClause(true);
    return this.#clauses;
  }

  #number(token: Token): void {
    const isNarrow = token.base === 0 && token.to - token.from <= 3;
    if (this.#isNamed && isNarrow && token.kind === 'number' && COUNT.test(this.#name)) {
      token.isCount = true;
      this.#begun = true;
      this.#endRow();
      this.#isNamed = false;
      return;
    }
    if (!this.#begun) this.#first = token;
    this.#begun = true;
    this.#row.push(token);
  }

  /** A duration behind a time is not a time: `10:31:01.137 +0.043`. */
  #time(time: string): void {
    if (this.#label.time === undefined || CLOCK_TIME.test(time)) this.#label = { ...this.#label, time };
  }

  #word({ start, end }: Mark): void {
    this.#begun = true;
    this.#endRow();
    this.#isNamed = false;
    // What follows `old` and `extra` is of that name: `extra data:`.
    if (!OLD.test(this.#name)) this.#name = this.#plain.slice(start, Math.min(end, start + LONGEST_NAME)).toLowerCase();
    this.#nameEnd = end;
    this.#words++;
    if (!OF_BYTES.test(this.#name)) this.#direct = false;
    if (AGAIN.test(this.#name)) this.#hint = 'again';
  }

  #side({ start, says = {} }: Mark): void {
    this.#begun = true;
    this.#endRow();
    const party = says.arrow === undefined ? this.#speaker(start, says.direction) : partyOf(this.#name);
    // What is said of a checksum stays so: `CRC received 0x0`.
    if (!CHECKSUM.test(this.#name)) this.#name = '';
    const {
      direction,
      transport,
      role = false,
      arrow,
    } = { ...says, ...(party && { direction: party, arrow: undefined }) };
    if (direction !== undefined) {
      const hasBytes = this.#runs.some(({ isName }) => !isName);
      if (!hasBytes) this.#runs = [];
      const known = this.#label.direction;
      // A role or an arrow says nothing beside a word that does: `Response from slave:`, `-> Received:`.
      const isWeak = (role || arrow !== undefined) && known !== undefined && !hasBytes;
      if (hasBytes) this.#endClause(known !== undefined);
      if (arrow === 'prompt' || (arrow !== undefined && direction === 'rx')) this.#arrow = direction;
      // Arduino's monitor puts `->` behind the time of every line.
      const isPrompt = arrow === 'prompt' && this.#label.time !== undefined && known === undefined && !hasBytes;
      if (!isWeak && !isPrompt) {
        this.#label = { ...this.#label, direction };
      }
      this.#direct = true;
    }
    if (transport !== undefined) this.#label = { ...this.#label, transport };
  }

  /** The direction of what a party is said to send or receive: `Slave TX`. */
  #speaker(start: number, direction: ChunkLabel['direction']): ChunkLabel['direction'] {
    const isBeside = start - this.#nameEnd === 1 && SPEAKER.test(this.#name);
    if (!isBeside || (direction !== 'tx' && direction !== 'rx')) return undefined;
    return (partyOf(this.#name) === 'request') === (direction === 'tx') ? 'request' : 'response';
  }

  #colon(): void {
    // The number before the colon is not a byte, unless nothing else in the line is.
    const named = this.#row.length > 0;
    const isOffset = this.#row.length === 1 && this.#first !== undefined && this.#first.to - this.#first.from >= 4;
    const name = this.#row.length > 1 ? this.#row.pop() : undefined;
    if (name !== undefined) {
      this.#endRow();
      this.#row.push(name);
    }
    this.#endRow(true);
    if (named && !isOffset) this.#words++;
    if (named) this.#name = '';
    if (TOTAL.test(this.#name)) this.#hint ??= 'total';
    this.#isNamed = true;
  }

  #bracket({ kind, start }: Mark): void {
    const character = this.#plain[start];
    if (character !== '[' && character !== ']') this.#endRow();
    if (character === '(') this.#parentheses++;
    if (character === ')') this.#parentheses = Math.max(0, this.#parentheses - 1);
    if (kind === 'open' && /buffer$/i.test(this.#name)) this.#name = '';
  }

  #endRow(isName = false): void {
    const row = this.#row;
    if (row.length === 0) return;
    this.#row = [];
    if (!row.some(isNumber)) {
      this.#words++;
      return;
    }
    const tokens = withoutProse(this.#plain, row);
    if (tokens.length < row.length) this.#words++;

    const said = { inParentheses: this.#parentheses > 0, isName, isNamed: this.#isNamed, name: this.#name };
    const added = run(this.#plain, tokens, said);
    if (this.#direct && !isName && added.style !== 'narrow') this.#followed += added.bytes;
    this.#runs.push(added);
    this.#isNamed = false;
    this.#name = '';
  }

  /** Ends a clause. What stands before the direction of others is not `alone`: it may count or name them. */
  #endClause(isLast: boolean): void {
    this.#endRow();
    this.#clauses.push({
      label: this.#label,
      runs: this.#runs,
      first: this.#first,
      alone: isLast && this.#words === 0,
      direct: this.#direct || this.#followed >= SEVERAL,
      hint: this.#hint,
      arrow: this.#arrow,
    });
    this.#runs = [];
    this.#first = undefined;
    this.#followed = 0;
    this.#hint = undefined;
  }
}
