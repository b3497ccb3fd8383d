import { Component } from 'preact';
import {
  type Fraction,
  fromRaw,
  numberTypeNames,
  numberTypes,
  orderName,
  ordersOf,
  readValue,
} from '../../../modbus/index.ts';
import {
  formatValue,
  readExact,
  readFraction,
  type UnitScale,
  type UnitWriting,
  writeInUnits,
} from '../../../notation/index.ts';
import { readScale, type ScaleFault, type ScaleTexts } from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { TextField } from '../../kit/text-field.tsx';
import { scaleTexts, setScale } from './scale.ts';
import { ScaleTable } from './scale-table.tsx';
import { valueWords as words } from './value-words.ts';

/** A scale that a device's profile has for the chosen register. */
export interface OfferedScale {
  readonly name: string;
  readonly known: UnitScale;
}

interface ScaleProps {
  /** From the chosen register on. */
  readonly registers: readonly number[];
  readonly offered: readonly OfferedScale[];
}

interface ScaleState {
  /** A raw number typed, beside what the registers held then. */
  readonly raw?: { readonly text: string; readonly of: string };
  readonly value: string;
}

/** What a raw number stands for in units, and the raw number for a value: raw = value × factor + offset. */
export class ScaleBox extends Component<ScaleProps, ScaleState> {
  override state: ScaleState = { value: '' };

  render() {
    const texts = scaleTexts.value;
    const { known, faults } = readScale(texts);
    const wrong = (name: ScaleFault) => (faults.has(name) ? words.scaleFaults[name] : '');
    const text = (name: Exclude<keyof ScaleTexts, 'type' | 'order'>, fault = '') => (
      <TextField
        id={`scale-${name}`}
        label={words.scaleLabels[name]}
        text={texts[name]}
        error={fault}
        onText={(typed) => setScale({ [name]: typed })}
      />
    );
    return (
      <details class="scale">
        <summary>{words.scale}</summary>
        <p class="said">{words.scaleHint}</p>
        {this.props.offered.map(({ name, known: offer }) => (
          <button type="button" key={name} onClick={() => setScale(textsOf(offer))}>
            {words.takeScale(name)}
          </button>
        ))}
        <div class="values-inputs">
          {text('factor', wrong('factor'))}
          {text('offset', wrong('offset'))}
          {text('decimals', wrong('decimals'))}
          {text('unit')}
          {text('least', wrong('least') || wrong('limits'))}
          {text('most', wrong('most'))}
          <Choice
            id="scale-type"
            label={words.scaleLabels.type}
            value={texts.type}
            options={numberTypeNames.map((value) => ({ value, name: `${value} ${words.typeNames[value]}` }))}
            onChoose={(type) => setScale({ type })}
          />
          <Choice
            id="scale-order"
            label={words.scaleLabels.order}
            value={texts.order}
            options={ordersOf(numberTypes[texts.type].registers).map((value) => ({
              value,
              name: `${orderName(value, numberTypes[texts.type].registers)} ${words.orderHints[value]}`,
            }))}
            onChoose={(order) => setScale({ order })}
          />
        </div>
        <div class="values-inputs">
          {this.raw(known)}
          {this.inUnits(known)}
        </div>
        {known && <ScaleTable known={known} />}
      </details>
    );
  }

  /** The raw number of the registers, or one's own, and what it stands for. */
  private raw(known: UnitScale | undefined) {
    const held = known ? rawText(this.props.registers, known) : '';
    const { raw } = this.state;
    const text = raw?.of === held ? raw.text : held;
    const exactly = readExact(text)?.exactly;
    const float = known && numberTypes[known.type].kind === 'float';
    const isRaw = exactly !== undefined && (float || exactly.denominator === 1n);
    const wrong = text === '' || isRaw ? '' : float ? words.notANumber : words.notWhole;
    return (
      <TextField
        id="scale-raw"
        label={words.raw}
        text={text}
        error={wrong}
        hint={known && isRaw ? standsFor(exactly, known) : ''}
        onText={(typed) => this.setState({ raw: { text: typed, of: held } })}
      />
    );
  }

  /** A value in units, and the raw number for it. */
  private inUnits(known: UnitScale | undefined) {
    const { value } = this.state;
    const number = readFraction(withoutUnit(value, known));
    const written = known && number ? writeInUnits(number, known) : undefined;
    const refused = written && written.kind !== 'registers' ? refusal(value, written) : '';
    return (
      <TextField
        id="scale-units"
        label={words.inUnits}
        text={value}
        error={number === undefined && value.trim() !== '' ? words.notANumber : refused}
        hint={written?.kind === 'registers' ? words.rawIs(written.inUnits) : ''}
        onText={(typed) => this.setState({ value: typed })}
      />
    );
  }
}

/** The raw number that registers hold; blank where they hold none. */
function rawText(registers: readonly number[], { type, order }: UnitScale): string {
  const reading = readValue(registers, type, order);
  if (reading.kind !== 'value' || typeof reading.value === 'string' || !isNumber(reading.value)) return '';
  // Bits are a number here.
  return formatValue(reading.value, type === 'bits' ? 'u16' : type);
}

const isNumber = (value: number | bigint) => typeof value === 'bigint' || Number.isFinite(value);

function standsFor(raw: Fraction, { unit, scale }: UnitScale): string {
  const { least, most, decimals } = scale;
  return words.standsFor(fromRaw(raw, scale), { unit, least, most, decimals });
}

const withoutUnit = (text: string, known: UnitScale | undefined): string => {
  const trimmed = text.trim();
  const unit = known?.unit ?? '';
  return unit !== '' && trimmed.toLowerCase().endsWith(unit.toLowerCase()) ? trimmed.slice(0, -unit.length) : trimmed;
};

const refusal = (typed: string, written: Exclude<UnitWriting, { kind: 'registers' }>): string =>
  written.kind === 'outside-limits'
    ? words.fault({ code: 'outside-limits', typed, limits: written.limits })
    : words.fault({ code: 'outside-type', typed, raw: written.raw, type: written.type, limits: written.limits });

/** A device's scale as one types it. */
function textsOf({ unit, scale: { factor, offset, decimals }, type, order }: UnitScale): ScaleTexts {
  const text = ({ numerator, denominator }: Fraction) =>
    denominator === 1n ? String(numerator) : `${numerator}/${denominator}`;
  return {
    factor: text(factor),
    offset: text(offset),
    decimals: String(decimals),
    unit,
    least: '',
    most: '',
    type,
    order,
  };
}
