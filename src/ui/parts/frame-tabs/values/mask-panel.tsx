import { useState } from 'preact/hooks';
import type { NamedNumber } from '../../../../devices/index.ts';
import {
  type BitEffect,
  bitEffects,
  type Masks,
  maskedValue,
  masksFor,
  type Reading,
} from '../../../../modbus/index.ts';
import { formatBinary, formatBitNumbers, formatHex, readBitNumbers, readNumber } from '../../../../notation/index.ts';
import { type Draft, withText } from '../../../../workbench/index.ts';
import { disabledFor } from '../../../kit/disabled-for.ts';
import { Field } from '../../../kit/field.tsx';
import { TextField } from '../../../kit/text-field.tsx';
import { TextInput } from '../../../kit/text-input.tsx';
import type { CurrentFrame } from '../../current-frame.ts';
import { show } from '../../store.ts';
import { useWords } from '../../words.ts';
import { EFFECTS, NamedBits, namedBits, namesIn } from './mask-bits.tsx';

/** Every pair of an AND and an OR bit, and what becomes of a 0 and of a 1. */
const TRUTH = [
  [1, 0],
  [1, 1],
  [0, 0],
  [0, 1],
] as const;

/** The masks of function 16 from bits to set and to clear, and what they do. */
export function MaskPanel({ draft: current, frame }: CurrentFrame) {
  const words = useWords('values');
  const { labels } = useWords('page');
  /** Bits as typed, and the draft beside which they were typed: for any other draft they are out of date. */
  const [typed, setTyped] = useState<BitTexts & { readonly of: Draft }>();
  const reading = frame?.reading;
  const { andMask, orMask, referenceAddress } = reading?.fields ?? {};
  if (reading === undefined || typeof andMask !== 'number' || typeof orMask !== 'number') return null;
  const texts: BitTexts = typed?.of === current ? typed : textsOf({ andMask, orMask });
  const set = readBitNumbers(texts.set);
  const clear = readBitNumbers(texts.clear);
  const read = set.kind === 'bits' && clear.kind === 'bits' ? { set: set.mask, clear: clear.mask } : undefined;
  const both = read ? read.set & read.clear : 0;
  const wanted = read && both === 0 ? masksFor(read.set, read.clear) : undefined;
  const masks = typed?.of === current ? wanted : { andMask, orMask };
  const bits = namedBits(referenceAddress);
  const type = (change: Partial<BitTexts>) => setTyped({ of: current, ...texts, ...change });
  const choose = (bit: number, effect: BitEffect) => {
    const with1 = (mask: number, one: boolean) => formatBitNumbers((mask & ~(1 << bit)) | (one ? 1 << bit : 0));
    if (read) type({ set: with1(read.set, effect === 'set'), clear: with1(read.clear, effect === 'clear') });
  };
  const use = () => {
    if (wanted === undefined) return;
    const withAnd = withText(current, 'andMask', formatHex(wanted.andMask, 4));
    show(withText(withAnd, 'orMask', formatHex(wanted.orMask, 4)), 'step');
  };
  const field = (name: 'set' | 'clear', label: string, of: typeof set, twice = '') => (
    <TextField
      id={`mask-${name}`}
      label={label}
      text={texts[name]}
      error={of.kind === 'wrong' ? words.notABit(of.text) : twice}
      hint={words.bitsHint}
      onText={(text) => type({ [name]: text })}
    />
  );
  return (
    <section aria-labelledby="mask">
      <h3 id="mask">{words.mask}</h3>
      <p class="said">{words.maskIntro}</p>
      <div class="values-inputs in-row">
        {field('set', words.setBits, set)}
        {field('clear', words.clearBits, clear, both === 0 ? '' : words.bothWays(formatBitNumbers(both)))}
      </div>
      {masks && read && <NamedBits bits={bits} effects={bitEffects(masks)} onChoose={choose} />}
      <div aria-live="polite">
        {masks && (
          <p class="mono masks">
            {labels['andMask']} {formatHex(masks.andMask, 4)} {formatBinary(masks.andMask, 16)}
            <br />
            {labels['orMask']} {formatHex(masks.orMask, 4)} {formatBinary(masks.orMask, 16)}
          </p>
        )}
      </div>
      <button type="button" {...disabledFor(wanted === undefined ? words.maskIntro : undefined)} onClick={use}>
        {words.useMasks}
      </button>
      {masks && <AfterMasks masks={masks} bits={bits} />}
      {masks && <Truth masks={masks} reading={reading} />}
    </section>
  );
}

interface BitTexts {
  readonly set: string;
  readonly clear: string;
}

/** The bits that masks set and clear. */
const textsOf = ({ andMask, orMask }: Masks): BitTexts => ({
  set: formatBitNumbers(~andMask & orMask & 0xffff),
  clear: formatBitNumbers(~andMask & ~orMask & 0xffff),
});

/** What a register with any value would become. */
function AfterMasks({ masks, bits }: { readonly masks: Masks; readonly bits: readonly NamedNumber[] }) {
  const words = useWords('values');
  const [current, setCurrent] = useState('0x1234');
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
      <TextInput id="mask-current" text={current} wrong={!fits} onText={setCurrent} />
    </Field>
  );
}

/** What each pair of bits in the masks does, and which bits of this frame it is. */
function Truth({ masks, reading }: { masks: Masks; reading: Reading }) {
  const words = useWords('values');
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
