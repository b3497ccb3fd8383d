import { Popover } from '../../kit/popover.tsx';
import { device } from '../../parts/device/naming.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';

const named = part(
  ['values'],
  () => import('./named-values.tsx'),
  ({ NamedValues }) => NamedValues,
);
const typed = part(
  ['values'],
  () => import('./typed-box.tsx'),
  ({ TypedBox }) => TypedBox,
);

const unit = part(
  ['values', 'devices'],
  () => import('./unit-help.tsx'),
  ({ UnitHelp }) => UnitHelp,
);

interface PlaceProps {
  /** The path of a field that holds registers. */
  readonly path: string;
}

/** Below a field that holds registers: what the device has names for among them. */
export const NamedPlace = ({ path }: PlaceProps) => device.value !== undefined && <Slot part={named} with={{ path }} />;

interface UnitPlaceProps extends PlaceProps {
  /** A unit that was typed, of which nothing here says what it is in registers. */
  readonly unit: string | undefined;
}

/** At a field with a value in a unit that nothing here knows: what would give it a meaning. */
export const UnitPlace = ({ path, unit: typed }: UnitPlaceProps) =>
  typed !== undefined && <Slot part={unit} with={{ path, unit: typed }} />;

/** At a field that holds registers: typed values that become its registers. */
export function TypedPlace({ path }: PlaceProps) {
  const { writeValues } = useWords('page').page;
  return (
    <Popover class="write-values" summary={writeValues}>
      {() => <Slot part={typed} with={{ path }} />}
    </Popover>
  );
}
