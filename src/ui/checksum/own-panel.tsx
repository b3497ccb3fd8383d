import type { ChecksumView } from '../../store/index.ts';
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
import { disabledFor } from '../kit/disabled-for.ts';
import { TextField } from '../kit/text-field.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';

/** Own parameters. */
export function OwnPanel({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const texts = view.shown.value.own;
  const set = (part: Partial<OwnTexts>) => view.change({ own: { ...texts, ...part } });
  const { crc, faults, values } = readOwn(texts);
  const chosen = view.chosen.value.crc;
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
        onText={(text) => set({ [name]: text })}
      />
    );
  };
  const tick = (name: 'refin' | 'refout') => (
    <label class="tick">
      <input
        type="checkbox"
        checked={texts[name]}
        onChange={({ currentTarget }) => set({ [name]: currentTarget.checked })}
      />{' '}
      {words.parameters[name]}
    </label>
  );
  return (
    <div class="own">
      <div class="own-fields field-grid">
        {field('width')}
        {field('poly')}
        <Choice
          id="own-form"
          label={words.polyAs}
          value={texts.polyAs}
          options={polynomialKinds.map((value) => ({ value, name: words.polynomialKinds[value] }))}
          onChoose={(polyAs) => set({ polyAs })}
        />
        {field('init')}
        {field('xorout')}
        <div class="ticks stack">
          {tick('refin')}
          {tick('refout')}
        </div>
      </div>
      {crc && <p class="mono soft">{powersOf(crc)}</p>}
      <div class="actions">
        <button
          type="button"
          class="first"
          {...disabledFor(crc === undefined ? words.ownWrong : undefined)}
          onClick={() => view.change({ algorithm: 'own' })}
        >
          {words.useOwn}
        </button>
        {chosen && (
          <button type="button" onClick={() => set(ownTexts(chosen))}>
            {words.fromChosen}
          </button>
        )}
      </div>
    </div>
  );
}
