import { type Field, LAST_ADDRESS } from '../../../modbus/index.ts';
import { readNumber, zeroBasedAddress } from '../../../notation/index.ts';
import { TextInput } from '../../kit/text-input.tsx';
import { devicesCame } from '../../parts/device/naming.ts';
import { Labelled } from '../../parts/labelled.tsx';
import { useSteady } from '../../parts/steady.ts';
import { draft, edit, evaluation, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { numberHint, useField } from '../use-field.ts';
import { AddressHelp } from './address-help.tsx';
import { addresses } from './convention.ts';

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
            ? say.is(table, address)
            : numberHint(field, text, words)
      }
      beside={
        table && (
          <>
            <OpenReadings path={path} />
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

/** Both readings of an address that may be a manual's number, while nobody has said which: the other is one click away. */
function OpenReadings({ path }: Pick<AddressProps, 'path'>) {
  const words = useWords('tools').addresses;
  const open = useSteady(() => page.openReading(path), [path]).value;
  if (open === undefined) return null;
  const { typed, table, taken } = open;
  return (
    <fieldset class="open-reading" data-severity="warning">
      <legend class="problem">{words.twoReadings(typed)}</legend>
      {(['number', 'address'] as const).map((which) => (
        <button key={which} type="button" aria-pressed={which === taken} onClick={() => page.settle(path, which)}>
          {which === 'number' ? words.asNumber(table, open.number) : words.asAddress(open.address)}
        </button>
      ))}
    </fieldset>
  );
}
