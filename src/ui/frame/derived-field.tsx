import { useLayoutEffect, useRef } from 'preact/hooks';
import { formatBytes, formatHex } from '../../notation/index.ts';
import { TextInput } from '../kit/text-input.tsx';
import { ErrorLine, idOf, Labelled } from '../parts/labelled.tsx';
import { useSteady } from '../parts/steady.ts';
import { evaluation, fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { useField } from './use-field.ts';

/** A value that the encoder works out, and that can be forced to another in its place; or a field of the frame that is forced. */
export function DerivedField({ name }: { readonly name: string }) {
  const { page: words } = useWords('page');
  const { labelled, input } = useField(name);
  const { forced, value, span } = fields.at(name);
  const { label, error, section } = labelled;
  const byHand = useRef(false);
  const isForced = forced.value !== undefined;
  const bytes = useSteady(() => {
    const { frame } = evaluation.value;
    const at = span.value;
    return name === 'checksum' && frame && at ? formatBytes(frame.bytes.subarray(at.from, at.to)) : undefined;
  }, [name]).value;
  useLayoutEffect(() => {
    if (isForced && byHand.current) document.getElementById(idOf(name))?.focus();
  }, [isForced]);
  if (forced.value !== undefined)
    return (
      <Labelled {...labelled} label={`${label} (${words.forced})`} class="with-button">
        <TextInput {...input} text={forced.value} onText={(text) => fields.typeForced(name, text)} />
        <button type="button" aria-label={words.unforceField(label)} onClick={() => fields.force(name, undefined)}>
          {words.unforce}
        </button>
      </Labelled>
    );
  const number = value.value;
  return (
    <div
      class="control derived-value"
      data-invalid={error === undefined ? undefined : ''}
      data-from={span.value?.from}
      data-to={span.value?.to}
    >
      <span class="label">{label}</span>
      <div class="in-row">
        <b class="mono">{bytes ?? (number === undefined ? '–' : `${number}, ${formatHex(number, 2)}`)}</b>
        <span class="said">{words.derived}</span>
        <button
          type="button"
          class="small"
          aria-label={words.forceField(label)}
          onClick={() => {
            byHand.current = true;
            fields.force(name, String(number ?? 0));
          }}
        >
          {words.force}
        </button>
      </div>
      {error !== undefined && (
        <span class="error">
          <ErrorLine error={error} section={section} />
        </span>
      )}
    </div>
  );
}
