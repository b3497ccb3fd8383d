import { Popover } from '../kit/popover.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { useSteady } from '../parts/steady.ts';
import { draft, edit, fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';

/** The request that a reply answers, and behind it the field where it is typed. */
export function Answering() {
  const words = useWords('stripMore');
  const text = useSteady(() => draft.value.answering).value;
  const error = fields.at('answering').error.value;
  return (
    <div class="control" data-invalid={error === undefined ? undefined : ''}>
      <span class="label">{words.answers}</span>
      <Popover
        class="answering"
        label={words.editAnswering(text === '' ? words.answersNothing : text)}
        summary={text === '' ? words.answersNothing : <span class="mono">{text}</span>}
      >
        {(close) => (
          <Labelled path="answering" label={words.answering} hint={words.answeringHint} error={error}>
            <TextInput
              id={idOf('answering')}
              text={text}
              wrong={error !== undefined}
              onText={(answering) => edit({ ...draft.value, answering })}
              onKey={(event) => {
                if (event.key !== 'Enter') return;
                // The button that gets the focus then is not pressed by this key.
                event.preventDefault();
                close();
              }}
            />
          </Labelled>
        )}
      </Popover>
    </div>
  );
}
