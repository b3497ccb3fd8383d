import type { Field } from '../../../modbus/index.ts';
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
  return (
    <>
      <Labelled
        {...labelled}
        hint={lost !== undefined && devicesCame.value ? say.notHere(lost) : numberHint(field, text, table, words)}
      >
        <TextInput
          {...input}
          text={shown}
          onText={(typed) => (table ? edit(addresses.withTyped(draft.value, path, typed, table)) : input.onText(typed))}
        />
      </Labelled>
      {table && <AddressHelp path={path} label={labelled.label} text={text} table={table} />}
    </>
  );
}
