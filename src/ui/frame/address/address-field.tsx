import type { Field, Table } from '../../../modbus/index.ts';
import { readNumber } from '../../../notation/index.ts';
import { TextInput } from '../../kit/text-input.tsx';
import { devicesCame } from '../../parts/device/naming.ts';
import { Labelled } from '../../parts/labelled.tsx';
import { useSteady } from '../../parts/steady.ts';
import { draft, edit, evaluation } from '../../parts/store.ts';
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
  const table = useSteady(() => evaluation.value.description.table).value;
  return table === undefined ? (
    <PlainAddress path={path} field={field} />
  ) : (
    <TableAddress path={path} field={field} table={table} />
  );
}

function PlainAddress({ path, field }: AddressProps) {
  const words = useWords('page');
  const { labelled, input, text } = useField(path);
  return (
    <Labelled {...labelled} hint={numberHint(field, text, undefined, words)}>
      <TextInput {...input} />
    </Labelled>
  );
}

function TableAddress({ path, field, table }: AddressProps & { readonly table: Table }) {
  const words = useWords('page');
  const { notHere: notHereText } = useWords('tools').addresses;
  const { labelled, input, text } = useField(path);
  const shown = useSteady(() => addresses.shown(draft.value, path, text, table), [path, text, table]).value;
  // A number counted in the way of another manual stands here as the frame has it; a name would be missed.
  const lost = shown.notHere !== undefined && readNumber(shown.notHere) === undefined ? shown.notHere : undefined;
  return (
    <>
      <Labelled
        {...labelled}
        hint={lost !== undefined && devicesCame.value ? notHereText(lost) : numberHint(field, text, table, words)}
      >
        <TextInput
          {...input}
          text={shown.text}
          onText={(typed) => edit(addresses.withTyped(draft.value, path, typed, table))}
        />
      </Labelled>
      <AddressHelp path={path} label={labelled.label} text={text} table={table} />
    </>
  );
}
