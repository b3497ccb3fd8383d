import type { ValuesNotice } from '../../../notation/index.ts';
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

const doubts = part(
  ['values', 'devices'],
  () => import('./doubts.tsx'),
  ({ Doubts }) => Doubts,
);

interface PlaceProps {
  /** The path of a field that holds registers. */
  readonly path: string;
}

/** Below a field that holds registers: what the device has names for among them. */
export const NamedPlace = ({ path }: PlaceProps) => device.value !== undefined && <Slot part={named} with={{ path }} />;

interface DoubtPlaceProps extends PlaceProps {
  readonly values: {
    /** A unit that was typed, of which nothing here says what it is in registers. */
    readonly unit?: string | undefined;
    readonly other?: ValuesNotice | undefined;
  };
}

/** At a field with a value that is in doubt: what would give its unit a meaning, and how else its number may be read. */
export const DoubtPlace = ({ path, values: { unit, other } }: DoubtPlaceProps) =>
  (unit !== undefined || other) && <Slot part={doubts} with={{ path, unit, other }} />;

/** At a field that holds registers: typed values that become its registers. */
export function TypedPlace({ path }: PlaceProps) {
  const { writeValues } = useWords('page').page;
  return (
    <Popover class="write-values" summary={writeValues}>
      {() => <Slot part={typed} with={{ path }} />}
    </Popover>
  );
}
