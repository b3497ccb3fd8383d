import { Component } from 'preact';
import type { NamedNumber } from '../../../devices/index.ts';
import { type BitEffect, bitEffects, type Masks, maskedValue, masksFor, type Reading } from '../../../modbus/index.ts';
import { formatBinary, formatBitNumbers, formatHex, readBitNumbers, readNumber } from '../../../notation/index.ts';
import { type Draft, withText } from '../../../workbench/index.ts';
import { Field } from '../../kit/field.tsx';
import { TextField } from '../../kit/text-field.tsx';
import { TextInput } from '../../kit/text-input.tsx';
import { words as pageWords } from '../../parts/page-words.ts';
import { step } from '../../parts/store.ts';
import { EFFECTS, NamedBits, namedBits, namesIn } from './mask-bits.tsx';
import { valueWords as words } from './value-words.ts';

interface MaskProps {
  readonly draft: Draft;
  readonly reading: Reading;
  readonly masks: Masks;
}

interface MaskState {
  /** Bits as typed, for the draft they were typed beside; of another draft they would be out of date. */
  readonly typed?: { readonly of: Draft; readonly set: string; readonly clear: string } | undefined;
  readonly current: string;
}

/** Every pair of an AND and an OR bit, and what becomes of a 0 and of a 1. */
const TRUTH = [
  [1, 0],
  [1, 1],
  [0, 0],
  [0, 1],
] as const;

/** The masks of function 16 from bits to set and to clear, and what they do. */
export class MaskPanel extends Component<MaskProps, MaskState> {
  override state: MaskState = { current: '0x1234' };

  /** Keeps, sets or clears one bit more. */
  private choose(
    bit: number,
    effect: BitEffect,
    { set, clear }: { readonly set: number; readonly clear: number },
  ): void {
    const others = ~(1 << bit);
    const here = (wanted: BitEffect) => (effect === wanted ? 1 << bit : 0);
    this.type({
      set: formatBitNumbers((set & others) | here('set')),
      clear: formatBitNumbers((clear & others) | here('clear')),
    });
  }

  private type(change: { readonly set?: string; readonly clear?: string }): void {
    const { draft } = this.props;
    this.setState({ typed: { of: draft, ...this.texts(), ...change } });
  }

  /** What stands in the fields: what was typed, or else what the frame's masks do. */
  private texts(): { readonly set: string; readonly clear: string } {
    const { draft, masks } = this.props;
    const { typed } = this.state;
    if (typed?.of === draft) return { set: typed.set, clear: typed.clear };
    const { andMask, orMask } = masks;
    return { set: formatBitNumbers(~andMask & orMask & 0xffff), clear: formatBitNumbers(~andMask & ~orMask & 0xffff) };
  }

  render() {
    const { draft } = this.props;
    const texts = this.texts();
    const set = readBitNumbers(texts.set);
    const clear = readBitNumbers(texts.clear);
    const both = set.kind === 'bits' && clear.kind === 'bits' ? set.mask & clear.mask : 0;
    const typed =
      set.kind === 'bits' && clear.kind === 'bits' && both === 0 ? masksFor(set.mask, clear.mask) : undefined;
    const masks = this.state.typed?.of === draft ? typed : this.props.masks;
    const bits = namedBits(this.props.reading.fields['referenceAddress']);
    const wrong = (read: typeof set) => (read.kind === 'wrong' ? words.notABit(read.text) : undefined);
    const twice = both === 0 ? undefined : words.bothWays(formatBitNumbers(both));
    return (
      <section class="panel values" aria-labelledby="mask">
        <h2 id="mask">{words.mask}</h2>
        <p class="said">{words.maskIntro}</p>
        <div class="values-inputs">
          {this.field('set', words.setBits, texts.set, wrong(set))}
          {this.field('clear', words.clearBits, texts.clear, wrong(clear) ?? twice)}
        </div>
        {masks && set.kind === 'bits' && clear.kind === 'bits' && (
          <NamedBits
            bits={bits}
            effects={bitEffects(masks)}
            onChoose={(bit, effect) => this.choose(bit, effect, { set: set.mask, clear: clear.mask })}
          />
        )}
        <div aria-live="polite">
          {masks && (
            <p class="mono masks">
              {pageWords.labels['andMask']} {formatHex(masks.andMask, 4)} {formatBinary(masks.andMask, 16)}
              <br />
              {pageWords.labels['orMask']} {formatHex(masks.orMask, 4)} {formatBinary(masks.orMask, 16)}
            </p>
          )}
        </div>
        <button type="button" disabled={typed === undefined} onClick={() => typed && this.use(typed)}>
          {words.useMasks}
        </button>
        {masks && this.current(masks, bits)}
        {masks && <Truth masks={masks} reading={this.props.reading} />}
      </section>
    );
  }

  private use({ andMask, orMask }: Masks): void {
    const withAnd = withText(this.props.draft, 'andMask', formatHex(andMask, 4));
    step(withText(withAnd, 'orMask', formatHex(orMask, 4)));
  }

  private field(name: 'set' | 'clear', label: string, text: string, wrong: string | undefined) {
    return (
      <TextField
        id={`mask-${name}`}
        label={label}
        text={text}
        error={wrong}
        hint={words.bitsHint}
        onText={(typed) => this.type({ [name]: typed })}
      />
    );
  }

  /** What a register with a value of one's choice would become. */
  private current(masks: Masks, bits: readonly NamedNumber[]) {
    const { current } = this.state;
    const value = readNumber(current);
    const fits = value !== undefined && Number.isInteger(value) && value >= 0 && value <= 0xffff;
    const after = fits ? maskedValue(value, masks) : 0;
    return (
      <Field
        id="mask-current"
        class="after-masks"
        label={words.current}
        error={fits ? undefined : words.notARegister(current)}
        hint={
          <>
            {words.becomes}{' '}
            <b class="mono">
              {after}, {formatHex(after, 4)}, {formatBinary(after, 16)}
            </b>{' '}
            {namesIn(bits, after)}
          </>
        }
      >
        <TextInput
          id="mask-current"
          text={current}
          wrong={!fits}
          onText={(typed) => this.setState({ current: typed })}
        />
      </Field>
    );
  }
}

/** What each pair of bits in the masks does, and which bits of this frame it is. */
function Truth({ masks, reading }: { masks: Masks; reading: Reading }) {
  const effects = bitEffects(masks);
  const spans = reading.spans.filter(({ name }) => name === 'andMask' || name === 'orMask');
  const bitsWith = (and: number, or: number) =>
    effects.reduce((mask, _, bit) => {
      const here = ((masks.andMask >> bit) & 1) === and && ((masks.orMask >> bit) & 1) === or;
      return here ? mask | (1 << bit) : mask;
    }, 0);
  return (
    <table class="truth">
      <caption>{words.truth}</caption>
      <thead>
        <tr>
          {[words.andBit, words.orBit, words.from0, words.from1, words.effect, words.bits].map((head) => (
            <th scope="col" key={head}>
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {TRUTH.map(([and, or]) => {
          const one = { andMask: and, orMask: or };
          const effect = EFFECTS.find((each) => each === bitEffects(one)[0]) ?? 'keep';
          return (
            <tr key={`${and}${or}`} data-kind="number" data-from={spans[0]?.from} data-to={spans.at(-1)?.to}>
              <td class="mono">{and}</td>
              <td class="mono">{or}</td>
              <td class="mono">{maskedValue(0, one)}</td>
              <td class="mono">{maskedValue(1, one) & 1}</td>
              <td>{words.effects[effect]}</td>
              <td class="mono">{formatBitNumbers(bitsWith(and, or)) || words.noBits}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
