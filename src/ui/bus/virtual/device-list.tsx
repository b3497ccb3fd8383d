import { useState } from 'preact/hooks';
import { type DeviceSetup, sourceSetups } from '../../../bus/index.ts';
import { LAST_UNIT } from '../../../modbus/index.ts';
import { wholeNumber } from '../../../notation/index.ts';
import { deviceKinds, kindName } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { allDevices } from '../../parts/device/chosen.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';

interface ListProps {
  readonly chosen: number | undefined;
  readonly onChoose: (id: number) => void;
}

/** The devices on the line, as many as anybody wants. */
export function DeviceList({ chosen, onChoose }: ListProps) {
  const { devices: text, models } = useWords('virtual');
  const devices = bus.virtual.devices.value;
  /** The kinds that can be added, and the place of the chosen one among them. */
  const kinds = deviceKinds(allDevices.own.value);
  const [kind, setKind] = useState(0);
  /** The devices before a removal, until something else is done. */
  const [before, setBefore] = useState<readonly DeviceSetup[]>();
  const set = (next: readonly DeviceSetup[], undo?: readonly DeviceSetup[]) => {
    bus.virtual.setDevices(next);
    setBefore(undo);
  };
  const change = (id: number, changed: Partial<DeviceSetup>) =>
    set(devices.map((device) => (device.id === id ? { ...device, ...changed } : device)));
  const freeId = 1 + Math.max(0, ...[...devices, ...(before ?? [])].map(({ id }) => id));
  const add = () => {
    const units = new Set(devices.map(({ unit }) => unit));
    let unit = 1;
    while (units.has(unit) && unit < LAST_UNIT) unit++;
    const added = kinds[kind];
    if (added === undefined) return;
    set([...devices, { id: freeId, ...added, unit, on: true }]);
    onChoose(freeId);
  };
  // With new numbers, so that they are not taken for the present ones.
  const restart = () =>
    set(
      sourceSetups().map((setup, index) => ({ ...setup, id: freeId + index })),
      devices,
    );
  const units = devices.filter(({ on }) => on).map(({ unit }) => unit);
  const twice = [...new Set(units.filter((unit, index) => units.indexOf(unit) !== index))];
  return (
    <section aria-labelledby="virtual-devices">
      <h3 id="virtual-devices">{text.heading}</h3>
      <ul class="devices">
        {devices.map((device, index) => {
          const { id, unit, on } = device;
          const name = kindName(device, models);
          return (
            <li key={id} data-chosen={id === chosen ? '' : undefined}>
              <input
                type="checkbox"
                checked={on}
                aria-label={text.on(unit)}
                title={text.onHead}
                onChange={({ currentTarget }) => change(id, { on: currentTarget.checked })}
              />
              <NumberEntry
                label={`${text.unit(name)} (${index + 1})`}
                bare
                when="finished"
                value={unit}
                read={wholeNumber(1, LAST_UNIT)}
                wrong={text.unitWrong}
                onValue={(unit) => change(id, { unit })}
              />
              <button type="button" class="name" aria-pressed={id === chosen} onClick={() => onChoose(id)}>
                {name}
              </button>
              <button
                type="button"
                aria-label={text.remove(name, unit)}
                onClick={() => set(devices.toSpliced(index, 1), devices)}
              >
                {text.removeShort}
              </button>
            </li>
          );
        })}
      </ul>
      <p class="said" role="status">
        {devices.length === 0 && text.none}
        {twice.length > 0 && <span class="error">{text.twice(twice)}</span>}
      </p>
      <div class="tools in-row">
        <label>
          {text.addKind}{' '}
          <Select
            value={kind}
            options={kinds.map((one, value) => ({ value, name: kindName(one, models) }))}
            onChoose={setKind}
          />
        </label>
        <button type="button" onClick={add}>
          {text.add}
        </button>
        {before && (
          <button type="button" onClick={() => set(before)}>
            {text.undo}
          </button>
        )}
        <button type="button" onClick={restart}>
          {text.restart}
        </button>
      </div>
    </section>
  );
}
