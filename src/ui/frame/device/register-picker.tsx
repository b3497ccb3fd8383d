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
  const fitting = useMemo(() => profile && fittingIn(profile, field()), [profile, description, isRequest]);
  const lists = useMemo(() => fitting && offeredOf(fitting, here, description.code), [fitting, here]);
  if (profile === undefined || lists === undefined) return null;
  const id = `register-${path}`;
  const { offered, hidden } = lists;
  return (
    <div class="register-picker">
      <label for={id}>{words.pick(profile.name)}</label>
      <Select
        id={id}
        label={words.pickFor(profile.name, label)}
        value={here ? profile.registers.indexOf(here) : -1}
        options={[
          { value: -1, name: words.pickNone, disabled: true },
          ...offered.map(({ index, register, wanted }) => ({
            value: index,
            name: lineName(register),
            group: words.pickWith(wanted),
          })),
          ...(hidden > 0 ? [{ value: -2, name: words.pickMore(hidden), disabled: true }] : []),
        ]}
        onChoose={(index) => {
          const register = profile.registers[index];
          if (register) edit(picked(field(), profile, register));
        }}
      />
      <Parts />
    </div>
  );
}

interface Fitting {
  readonly register: Register;
  /** In the profile. */
  readonly index: number;
  /** The function that it is picked with. */
  readonly wanted: number;
}

/** The registers that fit the frame. */
const fittingIn = (profile: Profile, field: AddressField): readonly Fitting[] =>
  profile.registers.flatMap((register, index) => {
    const wanted = functionFor(field, profile, register);
    return wanted === undefined ? [] : [{ register, index, wanted }];
  });

/** Those that are offered: first those that are picked with the frame's own function. */
function offeredOf(fitting: readonly Fitting[], here: Register | undefined, code: number) {
  const offered = fitting.filter(({ register }, place) => place < OFFERED || register === here);
  const first = offered.filter(({ wanted }) => wanted === code);
  return {
    offered: [...first, ...offered.filter(({ wanted }) => wanted !== code)],
    hidden: Math.max(0, fitting.length - OFFERED),
  };
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
  const { table } = description;
  if (table === undefined || table === 'file-record' || typeof first !== 'number') return undefined;
  for (const { register } of linesAt(profile, table, first)) {
    const requests = readRequests(profile, register);
    const at = requests.findIndex(
      ({ functionCode, fields: { startAddress, quantity } }) =>
        functionCode === description.code && startAddress === first && quantity === many,
    );
    if (requests.length > 1 && at >= 0) return { requests, at };
  }
  return undefined;
}
