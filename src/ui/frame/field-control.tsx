import type { Field } from '../../modbus/index.ts';
import { TextInput } from '../kit/text-input.tsx';
import { Labelled } from '../parts/labelled.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { AddressField } from './address/address-field.tsx';
import { numberHint, useField } from './use-field.ts';
import { useTypedValues } from './use-typed-values.ts';
import { DoubtPlace, NamedPlace, TypedPlace } from './values/write-values.tsx';

export const otherField = part(
  ['oneByOne'],
  () => import('./other-field.tsx'),
  ({ OtherField }) => OtherField,
);

/** The kinds of values whose controls are less common than a number: they come with the first of them. */
const OTHER: ReadonlySet<string> = new Set(['groups', 'flag', 'choice', 'bits', 'registers', 'list', 'bytes']);

export const isOther = ({ kind }: Field): boolean => OTHER.has(kind);

/** The control of a field, by the kind of value it holds. */
export function FieldControl({ path }: { readonly path: string }) {
  const field = fields.at(path).field.value;
  if (field === undefined) return null;
  if (isOther(field)) return <Slot part={otherField} with={{ path, inner: FieldControl }} />;
  return field.kind === 'address' ? (
    <AddressField path={path} field={field} />
  ) : (
    <NumberField path={path} field={field} />
  );
}

interface FieldProps {
  readonly path: string;
  readonly field: Field;
}

function NumberField({ path, field }: FieldProps) {
  const words = useWords('page');
  const { labelled, input, text } = useField(path);
  const values = useTypedValues(path, input.wrong);
  return (
    <>
      <Labelled
        {...labelled}
        hint={values.hint ?? numberHint(field, text, words)}
        error={labelled.error && (values.wrong ?? labelled.error)}
        beside={
          values.takes && (
            <>
              <DoubtPlace path={path} values={values} />
              <TypedPlace path={path} />
            </>
          )
        }
      >
        <TextInput {...input} {...values.input} />
      </Labelled>
      {values.takes && <NamedPlace path={path} />}
    </>
  );
}
