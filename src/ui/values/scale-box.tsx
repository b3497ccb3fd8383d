import { Component } from 'preact';
import { type Fraction, formatFraction, fromRaw, type Scale, toRaw } from '../../modbus/index.ts';
import { formatHex, readExact, readFraction } from '../../notation/index.ts';
import { Remembered } from '../tools/remembered.ts';
import { valueWords as words } from './language.ts';

interface ScaleTexts {
  readonly factor: string;
  readonly offset: string;
  readonly decimals: string;
}

/** The scale as typed last. */
const scaleTexts = new Remembered<ScaleTexts>('scale', { factor: '1', offset: '0', decimals: '1' }, (value) => {
  const { factor, offset, decimals } = (value ?? {}) as Partial<ScaleTexts>;
  return typeof factor === 'string' && typeof offset === 'string' && typeof decimals === 'string'
    ? { factor, offset, decimals }
    : undefined;
});

/** Digits shown behind those asked for, where a number is not exact. */
const MORE_DIGITS = 4;

interface ScaleProps {
  /** What the chosen register holds. */
  readonly register: number;
}

interface ScaleState {
  /** A raw number typed beside the register it was typed for. */
  readonly raw?: { readonly text: string; readonly of: number };
  readonly value: string;
}

/** What a raw number stands for in units, and the raw number for a value: raw = value × factor + offset. */
export class ScaleBox extends Component<ScaleProps, ScaleState> {
  override state: ScaleState = { value: '' };

  render() {
    const { register } = this.props;
    const { raw: typed, value } = this.state;
    const texts = scaleTexts.value;
    const raw = typed?.of === register ? typed.text : String(register);
    const factor = readFraction(texts.factor);
    const offset = readFraction(texts.offset);
    const decimals = /^(\d|1[0-2])$/.test(texts.decimals.trim()) ? Number(texts.decimals) : undefined;
    const whole = readExact(raw)?.exactly;
    const units = readFraction(value);
    const scale =
      factor && factor.numerator !== 0n && offset && decimals !== undefined ? { factor, offset, decimals } : undefined;
    const set = (change: Partial<ScaleTexts>) => {
      scaleTexts.value = { ...texts, ...change };
      this.forceUpdate();
    };
    const isWhole = whole?.denominator === 1n;
    return (
      <details class="scale">
        <summary>{words.scale}</summary>
        <p class="said">{words.scaleHint}</p>
        <div class="values-inputs">
          {field('factor', words.factor, texts.factor, scaleFault(factor, true), (text) => set({ factor: text }))}
          {field('offset', words.offset, texts.offset, scaleFault(offset, false), (text) => set({ offset: text }))}
          {field('decimals', words.decimals, texts.decimals, decimals === undefined ? words.notDecimals : '', (text) =>
            set({ decimals: text }),
          )}
        </div>
        <div class="values-inputs">
          {field(
            'raw',
            words.raw,
            raw,
            isWhole ? '' : words.notWhole,
            (text) => this.setState({ raw: { text, of: register } }),
            scale && whole && isWhole ? standsFor(whole.numerator, scale) : '',
          )}
          {field(
            'units',
            words.inUnits,
            value,
            units || value.trim() === '' ? '' : words.notANumber,
            (text) => this.setState({ value: text }),
            scale && units ? rawFor(units, scale) : '',
          )}
        </div>
      </details>
    );
  }
}

const scaleFault = (read: Fraction | undefined, isFactor: boolean): string =>
  read === undefined || (isFactor && read.numerator === 0n) ? (isFactor ? words.notAFactor : words.notANumber) : '';

function standsFor(raw: bigint, scale: Scale): string {
  const { value, exactly, exact } = fromRaw(raw, scale);
  const { decimals } = scale;
  return words.standsFor(
    formatFraction(value, decimals),
    exact ? undefined : formatFraction(exactly, decimals + MORE_DIGITS),
  );
}

function rawFor(value: Fraction, scale: Scale): string {
  const reading = toRaw(value, scale);
  if (reading.kind !== 'raw') return '';
  const { raw, exact, stands } = reading;
  const hex = raw >= 0n && raw <= 0xffffn ? formatHex(Number(raw), 4) : undefined;
  return words.rawFor(String(raw), hex, exact ? undefined : formatFraction(stands, scale.decimals + MORE_DIGITS));
}

/** A labelled input with what is wrong with it, or else what it comes to. */
function field(name: string, label: string, text: string, wrong: string, onText: (text: string) => void, said = '') {
  return (
    <div class="control" data-invalid={wrong === '' ? undefined : ''}>
      <label for={`scale-${name}`}>{label}</label>
      <input
        id={`scale-${name}`}
        class="mono"
        autocomplete="off"
        spellcheck={false}
        value={text}
        aria-invalid={wrong !== ''}
        aria-describedby={`scale-${name}-said`}
        onInput={({ currentTarget }) => onText(currentTarget.value)}
      />
      <p class={wrong === '' ? 'said' : 'said error'} id={`scale-${name}-said`} aria-live="polite">
        {wrong || said}
      </p>
    </div>
  );
}
