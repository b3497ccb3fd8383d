import { useLayoutEffect, useRef } from 'preact/hooks';
import { requestsOf } from '../../bus/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { Question as Asked } from '../../store/index.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

/** Requests shown of a job. */
const SHOWN = 12;

/** Asks whether requests are to be sent, if somebody is to be asked. Escape is no. */
export const Question = () => bus.question.value && <QuestionDialog {...bus.question.value} />;

function QuestionDialog({ command, why }: Asked) {
  const { guard } = useWords('bus');
  const { summary } = useWords('page').page;
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => dialog.current?.showModal(), []);
  const { transport } = bus.rules.value;
  const requests = (command.kind === 'send' ? [command.request] : requestsOf(command.order)).map((bytes) => ({
    bytes,
    reading: decodeFrame(bytes, { transport, direction: 'request' }),
  }));
  const units = new Set(requests.map(({ reading }) => reading.unitId));
  return (
    <dialog
      ref={dialog}
      aria-labelledby="question-title"
      onCancel={(event) => {
        event.preventDefault();
        bus.answer(false);
      }}
    >
      <h2 id="question-title">{guard.title}</h2>
      <p>{guard.doubt(why, [...units])}</p>
      <ul class="asked">
        {requests.slice(0, SHOWN).map(({ bytes, reading }, index) => (
          <li key={index}>
            {summary(reading, bytes.length, transport)}
            <br />
            <span class="mono">{formatBytes(bytes)}</span>
          </li>
        ))}
        {requests.length > SHOWN && <li>{guard.more(requests.length - SHOWN)}</li>}
      </ul>
      <div class="actions">
        <button type="button" onClick={() => bus.answer(false)}>
          {guard.no}
        </button>
        <button type="button" class="first" onClick={() => bus.answer(true)}>
          {guard.yes}
        </button>
      </div>
    </dialog>
  );
}
