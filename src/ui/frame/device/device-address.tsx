import { type NamedPlace, type Profile, placesNamed } from '../../../devices/index.ts';
import type { Table } from '../../../modbus/index.ts';
import { zeroBasedAddress } from '../../../notation/index.ts';
import { allDevices, ChosenDevice, onceCame } from '../../parts/device/chosen.ts';
import { useWords } from '../../parts/words.ts';
import { RegisterPicker } from './register-picker.tsx';

/** Most devices that are offered for a name. */
const OFFERED = 4;

export interface DeviceAddressProps {
  readonly path: string;
  /** The field's label. */
  readonly label: string;
  /** The text of the frame's field. */
  readonly text: string;
  readonly table: Table;
  /** Is called with a name that the chosen device knows. */
  readonly onName: (name: string) => void;
}

/** Below an address field: the devices that know what is typed as a name, and the registers of the chosen device. */
export const DeviceAddress = onceCame(Address);

function Address({ path, label, text, table, onName }: DeviceAddressProps) {
  const words = useWords('devices');
  const chosen = allDevices.chosen.value;
  return (
    <>
      <ChosenDevice />
      <div aria-live="polite">
        {offersFor(text, table, chosen).map(({ profile, place }) => {
          const where = words.placeText(place.table, place.address);
          return (
            <div key={profile.id} class="trap edged" data-severity="note">
              <p>{words.known(text.trim(), place.name, profile.name)}</p>
              <button
                type="button"
                onClick={() => {
                  allDevices.choose(profile.id);
                  onName(text.trim());
                }}
              >
                {profile === chosen ? words.useName(where) : words.chooseAndUse(profile.name, where)}
              </button>
            </div>
          );
        })}
      </div>
      {chosen && chosen.registers.length > 0 && table !== 'file-record' && (
        <RegisterPicker key={chosen.id} path={path} label={label} />
      )}
    </>
  );
}

interface Offer {
  readonly profile: Profile;
  readonly place: NamedPlace;
}

/** The devices that know a text that is not an address: the chosen one alone, if it does. */
function offersFor(text: string, table: Table, chosen: Profile | undefined): readonly Offer[] {
  if (text.trim() === '' || zeroBasedAddress(text) !== undefined) return [];
  const offer = (profile: Profile): Offer[] => {
    const places = placesNamed(profile, text);
    const place = places.find((each) => each.table === table) ?? places[0];
    return place ? [{ profile, place }] : [];
  };
  const known = chosen ? offer(chosen) : [];
  return known.length > 0 ? known : allDevices.all.value.flatMap(offer).slice(0, OFFERED);
}
