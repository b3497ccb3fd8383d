import type { CatalogueCrc } from '../../modbus/index.ts';
import {
  byteHex,
  type OwnNumber,
  type OwnTexts,
  ownTexts,
  polynomialKinds,
  powersOf,
  readOwn,
  registerHex,
} from '../../workbench/index.ts';
import { Choice } from '../kit/choice.tsx';
import { TextField } from '../kit/text-field.tsx';
import { checksumWords as words } from './checksum-words.ts';

interface OwnProps {
  readonly texts: OwnTexts;
  /** The algorithm that is chosen, to begin with. */
  readonly chosen: CatalogueCrc | undefined;
  readonly onTexts: (texts: OwnTexts) => void;
  readonly onUse: (crc: CatalogueCrc) => void;
  readonly onLeave: () => void;
}

/** Own parameters. */
export function OwnPanel({ texts, chosen, onTexts, onUse, onLeave }: OwnProps) {
  const { crc, faults, values } = readOwn(texts);
  const field = (name: OwnNumber) => {
    const fault = faults[name];
    const value = values[name];
    return (
      <TextField
        id={`own-${name}`}
        label={words.parameters[name]}
        text={texts[name]}
        error={fault && words.ownFault(fault)}
        hint={
          value === undefined
            ? words.parameterHints[name]
            : words.isNumber(value, name === 'width' ? byteHex(value) : registerHex(values.width ?? 0, value))
        }
        onText={(text) => onTexts({ ...texts, [name]: text })}
      />
    );
  };
  const tick = (name: 'refin' | 'refout') => (
    <label class="tick">
      <input
        type="checkbox"
        checked={texts[name]}
        onChange={({ currentTarget }) => onTexts({ ...texts, [name]: currentTarget.checked })}
      />{' '}
      {words.parameters[name]}
    </label>
  );
  return (
    <div class="own" onFocusOut={onLeave}>
      <div class="own-fields">
        {field('width')}
        {field('poly')}
        <Choice
          id="own-form"
          label={words.polyAs}
          value={texts.polyAs}
          options={polynomialKinds.map((value) => ({ value, name: words.polynomialKinds[value] }))}
          onChoose={(polyAs) => onTexts({ ...texts, polyAs })}
        />
        {field('init')}
        {field('xorout')}
        <div class="ticks">
          {tick('refin')}
          {tick('refout')}
        </div>
      </div>
      {crc && <p class="mono powers">{powersOf(crc)}</p>}
      <div class="actions">
        <button type="button" class="first" disabled={crc === undefined} onClick={() => crc && onUse(crc)}>
          {words.useOwn}
        </button>
        {chosen && (
          <button type="button" onClick={() => onTexts(ownTexts(chosen))}>
            {words.fromChosen}
          </button>
        )}
      </div>
    </div>
  );
}
