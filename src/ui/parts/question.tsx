import { requestsOf } from '../../bus/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { Question as Asked, Bus } from '../../store/index.ts';
import { Dialog } from '../kit/dialog.tsx';
import { useWords } from './words.ts';

/** Requests shown of a job. */
const SHOWN = 12;

/** Asks whether requests are to be sent, if somebody is to be asked. Escape is no. */
export const Question = ({ bus }: { readonly bus: Bus }) =>
  bus.question.value && <QuestionDialog bus={bus} {...bus.question.value} />;

function QuestionDialog({ bus, command, why }: Asked & { readonly bus: Bus }) {
  const { guard } = useWords('bus');
  const { summary } = useWords('page').page;
  const { transport } = bus.rules.value;
  const requests = (command.kind === 'send' ? [command.request] : requestsOf(command.order)).map((bytes) => ({
    bytes,
    reading: decodeFrame(bytes, { transport, direction: 'request' }),
  }));
  const units = new Set(requests.map(({ reading }) => reading.unitId));
  const actions = (
    <>
      <button type="button" onClick={() => bus.answer(false)}>
        {guard.no}
      </button>
      <button type="button" class="first" onClick={() => bus.answer(true)}>
        {guard.yes}
      </button>
    </>
  );
  return (
    <Dialog title={guard.title} onClose={() => bus.answer(false)} actions={actions}>
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
    </Dialog>
  );
}
