import { formatHex } from '../../notation/index.ts';
import { TextInput } from '../kit/text-input.tsx';
import { ErrorLine, Labelled } from '../parts/labelled.tsx';
import { fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { useField } from './use-field.ts';

/** A value that the encoder works out, and that can be forced to another; or a field of the frame that is forced. */
export function DerivedField({ name }: { readonly name: string }) {
  const { page: words } = useWords('page');
  const { labelled, input } = useField(name);
  const { forced, value } = fields.at(name);
  const { label, error, section } = labelled;
  if (forced.value !== undefined)
    return (
      <Labelled {...labelled} label={`${label} (${words.forced})`}>
        <TextInput {...input} text={forced.value} onText={(text) => fields.typeForced(name, text)} />
        <button type="button" aria-label={words.unforceField(label)} onClick={() => fields.force(name, undefined)}>
          {words.unforce}
        </button>
      </Labelled>
    );
  const number = value.value;
  return (
    <p class="control derived-value" data-invalid={error === undefined ? undefined : ''}>
      <span>{label}</span> <b class="mono">{number === undefined ? '–' : `${number} ${formatHex(number, 2)}`}</b>
      <button
        type="button"
        aria-label={words.forceField(label)}
        onClick={() => fields.force(name, String(number ?? 0))}
      >
        {words.force}
      </button>
      {error !== undefined && (
        <span class="error">
          <ErrorLine error={error} section={section} />
        </span>
      )}
    </p>
  );
}
