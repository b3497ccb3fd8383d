import { useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import {
  lineName,
  linesAt,
  type Profile,
  type ReadRequest,
  type Register,
  readRequests,
} from '../../../devices/index.ts';
import { fieldValue } from '../../../modbus/index.ts';
import { type AddressField, functionFor, picked, requestDraft } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { allDevices } from '../../parts/device/chosen.ts';
import { draft, edit, evaluation, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** Most registers that are offered; the panel of the device finds the others. */
const OFFERED = 300;

interface PickerProps {
  readonly path: string;
  /** The label of the address field. */
  readonly label: string;
}

/** The registers of the chosen device, to be put into an address field by name. */
export function RegisterPicker({ path, label }: PickerProps) {
  const words = useWords('devices');
  // Only these values change the list: most keystrokes in the form do not.
  const description = useComputed(() => evaluation.value.description).value;
  const here = useComputed(() => registerHere(path)).value;
  const profile = allDevices.chosen.value;
  const isRequest = page.kind.value === 'request';
  const field = () => ({ draft: draft.peek(), evaluation: evaluation.peek(), path });
  const options = useMemo(
    () => profile && <Options profile={profile} here={here} field={field()} />,
    [profile, here, description, isRequest],
  );
  if (profile === undefined) return null;
  const id = `register-${path}`;
  return (
    <div class="register-picker">
      <label for={id}>{words.pick(profile.name)}</label>
      <select
        id={id}
        aria-label={words.pickFor(profile.name, label)}
        value={here ? String(profile.registers.indexOf(here)) : ''}
        onChange={({ currentTarget }) => {
          const register = profile.registers[Number(currentTarget.value)];
          if (register) edit(picked(field(), profile, register));
        }}
      >
        <option value="" disabled>
          {words.pickNone}
        </option>
        {options}
      </select>
      <Parts />
    </div>
  );
}

interface OptionsProps {
  readonly profile: Profile;
  readonly here: Register | undefined;
  readonly field: AddressField;
}

/** The registers by the function that each is picked with, those of the frame's function first. */
function Options({ profile, here, field }: OptionsProps) {
  const words = useWords('devices');
  const groups = new Map<number, { readonly register: Register; readonly index: number }[]>();
  groups.set(field.evaluation.description.code, []);
  let offered = 0;
  for (const [index, register] of profile.registers.entries()) {
    const wanted = functionFor(field, profile, register);
    if (wanted === undefined || (++offered > OFFERED && register !== here)) continue;
    groups.set(wanted, [...(groups.get(wanted) ?? []), { register, index }]);
  }
  return (
    <>
      {[...groups].map(([wanted, registers]) =>
        registers.length === 0 ? null : (
          <optgroup key={wanted} label={words.pickWith(wanted)}>
            {registers.map(({ register, index }) => (
              <option key={index} value={String(index)}>
                {lineName(register)}
              </option>
            ))}
          </optgroup>
        ),
      )}
      {offered > OFFERED && (
        <option value="more" disabled>
          {words.pickMore(offered - OFFERED)}
        </option>
      )}
    </>
  );
}

/** The line that holds the address in a field of the current frame. */
function registerHere(path: string): Register | undefined {
  const profile = allDevices.chosen.value;
  const { frame, description } = evaluation.value;
  const address = frame && fieldValue(frame.reading, path);
  const { table } = description;
  if (!profile || typeof address !== 'number' || table === undefined || table === 'file-record') return undefined;
  return linesAt(profile, table, address)[0]?.register;
}

/** All requests that read a line which is too long for one, where the current frame is one of them. */
function Parts() {
  const words = useWords('devices');
  const parts = useComputed(partsHere).value;
  if (parts === undefined) return null;
  const { requests, at } = parts;
  return (
    <>
      <label for="device-part">{words.partsOf(requests.length)}</label>
      <Select
        id="device-part"
        value={at}
        options={requests.map(({ fields: { startAddress, quantity } }, value) => ({
          value,
          name: words.part(value + 1, requests.length, startAddress, startAddress + quantity - 1),
        }))}
        onChoose={(index) => {
          const request = requests[index];
          if (request) edit(requestDraft(draft.value, request));
        }}
      />
    </>
  );
}

function partsHere(): { readonly requests: readonly ReadRequest[]; readonly at: number } | undefined {
  const { frame, description } = evaluation.value;
  const profile = allDevices.chosen.value;
  if (!profile || draft.value.kind !== 'request' || frame === undefined) return undefined;
  const [first, many] = ['startAddress', 'quantity'].map((name) => fieldValue(frame.reading, name));
  for (const register of profile.registers) {
    if (register.table !== description.table) continue;
    const requests = readRequests(profile, register);
    const at = requests.findIndex(
      ({ functionCode, fields: { startAddress, quantity } }) =>
        functionCode === description.code && startAddress === first && quantity === many,
    );
    if (requests.length > 1 && at >= 0) return { requests, at };
  }
  return undefined;
}
