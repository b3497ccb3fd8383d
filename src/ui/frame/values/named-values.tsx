import { type NamedValue, namedValues } from '../../../devices/index.ts';
import { type NumberTypeName, writeValue } from '../../../modbus/index.ts';
import { formatHex, readNumbers } from '../../../notation/index.ts';
import { placeOf, withText } from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { device } from '../../parts/device/naming.ts';
import { draft, evaluation, fields, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** Values with names that are offered; a frame rarely has more. */
const MOST = 8;

/** What the device has names for among the registers of a field: bits to tick, values to choose. */
export function NamedValues({ path }: { readonly path: string }) {
  const profile = device.value;
  const control = fields.at(path).control.value;
  const place = profile && control && placeOf(control, draft.value, evaluation.value);
  const list = place && readNumbers(control.text);
  if (!place || list?.kind !== 'list') return null;
  const found = namedValues(profile, place.table, place.first, list.items)
    .filter(({ register, raw }) => register.names.length > 0 && (typeof raw === 'number' || typeof raw === 'bigint'))
    .slice(0, MOST);
  const write = (value: NamedValue, number: number) => {
    const { type, order } = value.register;
    const written = writeValue(number, type as NumberTypeName, order);
    if (written.kind !== 'registers') return;
    // The items that are not touched keep their notation.
    const items = control.text.trim().split(/[\s,;]+/);
    const texts = written.registers.map((register) =>
      type === 'bits' || written.registers.length > 1 ? formatHex(register, 4) : String(register),
    );
    step(withText(draft.value, control.path, items.toSpliced(value.at, texts.length, ...texts).join(' ')));
  };
  return (
    <>
      {found.map((value) => {
        const One = value.register.type === 'bits' ? Bits : NamedNumber;
        return <One key={`${value.at} ${value.name}`} value={value} onWrite={(number) => write(value, number)} />;
      })}
    </>
  );
}

interface OneProps {
  readonly value: NamedValue;
  readonly onWrite: (number: number) => void;
}

function Bits({ value: { name, register, raw }, onWrite }: OneProps) {
  const words = useWords('values');
  const bits = Number(raw);
  return (
    <fieldset class="named-bits field-grid">
      <legend>{name}</legend>
      {register.names.map((bit) => (
        <label key={bit.number}>
          <input
            type="checkbox"
            checked={((bits >>> bit.number) & 1) === 1}
            onChange={() => onWrite((bits ^ (1 << bit.number)) & 0xffff)}
          />{' '}
          {words.namedBit(bit.number, bit.name)}
        </label>
      ))}
    </fieldset>
  );
}

const OTHER = 'other';

function NamedNumber({ value: { at, name, register, raw }, onWrite }: OneProps) {
  const words = useWords('values');
  const listed = register.names.some(({ number }) => number === Number(raw));
  const id = `named-${at}`;
  return (
    <Choice
      id={id}
      label={name}
      value={listed ? String(raw) : OTHER}
      options={[
        ...register.names.map((each) => ({
          value: String(each.number),
          name: words.namedNumber(each.number, each.name),
        })),
        ...(listed ? [] : [{ value: OTHER, name: words.unnamed(String(raw)) }]),
      ]}
      onChoose={(chosen) => chosen !== OTHER && onWrite(Number(chosen))}
    />
  );
}
