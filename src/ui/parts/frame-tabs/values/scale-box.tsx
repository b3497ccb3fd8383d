import { useState } from 'preact/hooks';
import { ratioText } from '../../../../devices/index.ts';
import { type Fraction, fromRaw, numberTypes, orderName, ordersOf, readValue } from '../../../../modbus/index.ts';
import { formatValue, readExact, readFraction, type UnitScale, writeInUnits } from '../../../../notation/index.ts';
import type { ValueWords } from '../../../../words/index.ts';
import { firstScale, readScale, type ScaleFault, type ScaleTexts, scaleTypes } from '../../../../workbench/index.ts';
import { Choice } from '../../../kit/choice.tsx';
import { TextField } from '../../../kit/text-field.tsx';
import { valueStore } from '../../value-store.ts';
import { useWords } from '../../words.ts';
import { ScaleTable } from './scale-table.tsx';

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

/** What a raw number stands for in units, and the raw number for a value: value = raw × factor + offset. */
export function ScaleBox({ registers, offered }: ScaleProps) {
  const words = useWords('values');
  const texts = valueStore.scale.value;
  const { setScale } = valueStore;
  const { known, faults } = readScale(texts);
  const size = numberTypes[texts.type].registers;
  const text = (name: Exclude<keyof ScaleTexts, 'type' | 'order' | 'version'>, ...wrong: readonly ScaleFault[]) => {
    const fault = wrong.find((one) => faults.has(one));
    return (
      <TextField
        id={`scale-${name}`}
        label={words.scaleLabels[name]}
        text={texts[name]}
        error={fault && words.scaleFaults[fault]}
        onText={(typed) => setScale({ [name]: typed })}
      />
    );
  };
  return (
    <details class="scale">
      <summary>{words.scale}</summary>
      <p class="said">{words.scaleHint}</p>
      {offered.map(({ name, known: offer }) => (
        <button type="button" key={name} onClick={() => setScale(textsOf(offer))}>
          {words.takeScale(name)}
        </button>
      ))}
      <div class="values-inputs in-row">
        {text('factor', 'factor')}
        {text('offset', 'offset')}
        {text('decimals', 'decimals')}
        {text('unit')}
        {text('least', 'least', 'limits')}
        {text('most', 'most')}
        <Choice
          id="scale-type"
          label={words.scaleLabels.type}
          value={texts.type}
          options={scaleTypes.map((value) => ({ value, name: `${value} ${words.typeNames[value]}` }))}
          onChoose={(type) => setScale({ type })}
        />
        <Choice
          id="scale-order"
          label={words.scaleLabels.order}
          value={texts.order}
          options={ordersOf(size).map((value) => ({
            value,
            name: `${orderName(value, size)} ${words.orderHints[value]}`,
          }))}
          onChoose={(order) => setScale({ order })}
        />
      </div>
      <div class="values-inputs in-row">
        <RawNumber registers={registers} known={known} />
        <InUnits known={known} />
      </div>
      {known && <ScaleTable known={known} />}
    </details>
  );
}

interface KnownProps {
  readonly known: UnitScale | undefined;
}

/** The raw number of the registers, or any other, and what it stands for. */
function RawNumber({ registers, known }: KnownProps & Pick<ScaleProps, 'registers'>) {
  const words = useWords('values');
  const held = known ? rawText(registers, known) : '';
  /** A raw number typed, and what the registers held then. */
  const [raw, setRaw] = useState({ text: '', of: '' });
  const text = raw.of === held ? raw.text : held;
  const exactly = readExact(text)?.exactly;
  const float = known && numberTypes[known.type].kind === 'float';
  const isRaw = exactly !== undefined && (float || exactly.denominator === 1n);
  return (
    <TextField
      id="scale-raw"
      label={words.raw}
      text={text}
      error={text === '' || isRaw ? '' : float ? words.notANumber : words.notWhole}
      hint={known && isRaw ? standsFor(exactly, known, words) : ''}
      onText={(typed) => setRaw({ text: typed, of: held })}
    />
  );
}

/** A value in units, and the raw number for it. */
function InUnits({ known }: KnownProps) {
  const words = useWords('values');
  const [value, setValue] = useState('');
  const number = readFraction(withoutUnit(value, known));
  const written = known && number ? writeInUnits(number, known) : undefined;
  const refused =
    written?.kind === 'outside-limits'
      ? words.fault({ ...written, code: 'outside-limits', typed: value })
      : written?.kind === 'outside-type'
        ? words.fault({ ...written, code: 'outside-type', typed: value })
        : '';
  return (
    <TextField
      id="scale-units"
      label={words.inUnits}
      text={value}
      error={number === undefined && value.trim() !== '' ? words.notANumber : refused}
      hint={written?.kind === 'registers' ? words.rawIs(written.inUnits) : ''}
      onText={setValue}
    />
  );
}

/** The raw number that registers hold; blank if they do not hold one. */
function rawText(registers: readonly number[], { type, order }: UnitScale): string {
  const reading = readValue(registers, type, order);
  if (reading.kind !== 'value' || typeof reading.value === 'string' || !isNumber(reading.value)) return '';
  // Bits are a number here.
  return formatValue(reading.value, type === 'bits' ? 'u16' : type);
}

const isNumber = (value: number | bigint) => typeof value === 'bigint' || Number.isFinite(value);

function standsFor(raw: Fraction, { unit, scale }: UnitScale, words: ValueWords): string {
  const { least, most, decimals } = scale;
  return words.standsFor(fromRaw(raw, scale), { unit, least, most, decimals });
}

const withoutUnit = (text: string, known: UnitScale | undefined): string => {
  const trimmed = text.trim();
  const unit = known?.unit ?? '';
  return unit !== '' && trimmed.toLowerCase().endsWith(unit.toLowerCase()) ? trimmed.slice(0, -unit.length) : trimmed;
};

/** A device's scale as it would be typed. */
function textsOf({ unit, scale: { factor, offset, decimals }, type, order }: UnitScale): ScaleTexts {
  return {
    ...firstScale,
    factor: ratioText(factor),
    offset: ratioText(offset),
    decimals: String(decimals),
    unit,
    type,
    order,
  };
}
