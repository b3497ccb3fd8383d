import { useState } from 'preact/hooks';
import { devicesWithUnit, placeOf, scaleOfFull } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { Popover } from '../../kit/popover.tsx';
import { TextField } from '../../kit/text-field.tsx';
import { allDevices, ChosenDevice } from '../../parts/device/chosen.ts';
import { ProfileButtons } from '../../parts/device/device-options.tsx';
import { draft, evaluation, fields } from '../../parts/store.ts';
import { valueStore } from '../../parts/value-store.ts';
import { useWords } from '../../parts/words.ts';
import { typeValues } from './typed-values.ts';

interface UnitHelpProps {
  readonly path: string;
  readonly unit: string;
}

/** What gives a unit its meaning, at the field where it was typed: a device that has it, or what full scale is. */
export function UnitHelp({ path, unit }: UnitHelpProps) {
  const words = useWords('values');
  /** Reads what stands in the field once more, as a step. */
  const readAgain = () => {
    const control = fields.at(path).control.peek();
    if (control) typeValues(control, control.text);
    fields.take();
  };
  return (
    <>
      <ChosenDevice />
      <Popover summary={words.chooseDevice}>
        {() => (
          <Devices
            path={path}
            unit={unit}
            onChosen={(id) => {
              allDevices.choose(id);
              readAgain();
            }}
          />
        )}
      </Popover>
      <Popover summary={words.sayFullScale}>{() => <FullScale unit={unit} onTaken={readAgain} />}</Popover>
    </>
  );
}

interface DevicesProps extends UnitHelpProps {
  readonly onChosen: (id: string) => void;
}

function Devices({ path, unit, onChosen }: DevicesProps) {
  const words = useWords('values');
  const control = fields.at(path).control.value;
  const place = control && placeOf(control, draft.value, evaluation.value);
  const profiles = devicesWithUnit(allDevices.all.value, unit, place);
  return profiles.length === 0 ? (
    <p>{words.noDevice(unit)}</p>
  ) : (
    <div class="device-options">
      <ProfileButtons profiles={profiles} onChoose={onChosen} />
    </div>
  );
}

interface FullScaleProps {
  readonly unit: string;
  readonly onTaken: () => void;
}

function FullScale({ unit, onTaken }: FullScaleProps) {
  const words = useWords('values');
  const [full, setFull] = useState('');
  const [raw, setRaw] = useState('8192');
  const scale = scaleOfFull(full, raw, unit);
  const take = () => {
    if (scale === undefined) return;
    valueStore.setScale(scale);
    onTaken();
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    take();
  };
  return (
    <>
      <TextField id="full-scale" label={words.fullScale(unit)} text={full} onText={setFull} onKey={onKey} />
      <TextField id="full-scale-raw" label={words.fullScaleRaw} text={raw} onText={setRaw} onKey={onKey} />
      <p class="said">{words.fullScaleHint(unit)}</p>
      <button
        type="button"
        class="first"
        {...disabledFor(scale === undefined ? words.fullScaleHint(unit) : undefined)}
        onClick={take}
      >
        {words.takeFullScale}
      </button>
    </>
  );
}
