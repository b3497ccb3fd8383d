import { type Field, LAST_ADDRESS } from '../../../modbus/index.ts';
import { readNumber, zeroBasedAddress } from '../../../notation/index.ts';
import { saysSixDigits } from '../../../workbench/index.ts';
import { TextInput } from '../../kit/text-input.tsx';
import { devicesCame } from '../../parts/device/naming.ts';
import { Labelled } from '../../parts/labelled.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useSteady } from '../../parts/steady.ts';
import { draft, edit, evaluation, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { numberHint, useField } from '../use-field.ts';
import { AddressHelp } from './address-help.tsx';
import { addresses } from './convention.ts';

const openReadings = part(
  ['tools'],
  () => import('./open-readings.tsx'),
  ({ OpenReadings }) => OpenReadings,
);

interface AddressProps {
  readonly path: string;
  readonly field: Field;
}

/** An address: typed as manuals print it, if the function has a table. */
export function AddressField({ path, field }: AddressProps) {
  const words = useWords('page');
  const { addresses: say } = useWords('tools');
  const { labelled, input, text } = useField(path);
  const { shown, notHere, table } = useSteady(() => {
    const { table } = evaluation.value.description;
    if (table === undefined) return { shown: text, notHere: undefined, table };
    const { text: shown, notHere } = addresses.shown(draft.value, path, text, table);
    return { shown, notHere, table };
  }, [path, text]).value;
  // A number counted in the way of another manual stands here as the frame has it; a name would be missed.
  const lost = notHere !== undefined && readNumber(notHere) === undefined ? notHere : undefined;
  const address = zeroBasedAddress(text);
  const known = table !== undefined && address !== undefined && isAddress(address);
  return (
    <Labelled
      {...labelled}
      hint={
        lost !== undefined && devicesCame.value
          ? say.notHere(lost)
          : known
            ? say.is(table, address, saysSixDigits(shown))
            : numberHint(field, text, words)
      }
      beside={
        table && (
          <>
            <OpenReadingsPlace path={path} />
            <AddressHelp path={path} label={labelled.label} text={text} table={table} />
          </>
        )
      }
    >
      <TextInput
        {...input}
        text={shown}
        onText={(typed) => (table ? edit(addresses.withTyped(draft.value, path, typed, table)) : input.onText(typed))}
      />
    </Labelled>
  );
}

const isAddress = (address: number) => Number.isInteger(address) && address >= 0 && address <= LAST_ADDRESS;

function OpenReadingsPlace({ path }: Pick<AddressProps, 'path'>) {
  const open = useSteady(() => page.openReading(path) !== undefined, [path]).value;
  return open && <Slot part={openReadings} with={{ path }} />;
}
