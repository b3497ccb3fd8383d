import { decodeFrame, sameBytes } from '../../../modbus/index.ts';
import type { Bus } from '../../../store/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useCommand, useKeyOf } from '../commands.ts';
import { Question } from '../question.tsx';
import { useSteady } from '../steady.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import './cause.css';

interface SendProps {
  readonly bus: Bus;
}

/** Sends the current request on the line that is open, and says what became of it; where it cannot be sent, why. */
export function SendButton({ bus }: SendProps) {
  const { send: words } = useWords('bus');
  const can = useSteady(() => {
    const { frame, stale, draft } = page.shown.value;
    const { transport, kind } = draft;
    if (frame === undefined || stale) return { why: words.noFrame };
    if (kind !== 'request') return { why: words.notRequest };
    if (transport === 'pdu') return { why: words.pdu };
    return transport === 'tcp' ? { why: words.tcp } : { transport };
  }, [words]).value;
  const sending = bus.sending.value;
  const send =
    can.transport && !sending
      ? () => {
          const { frame } = page.evaluation.peek();
          if (frame && can.transport) bus.send(frame.bytes, can.transport);
        }
      : undefined;
  useCommand('send', send);
  const key = useKeyOf('send');
  return (
    <>
      <button type="button" onClick={send} {...key} {...(send === undefined && disabledFor(can.why ?? words.sending))}>
        {words.send}
      </button>
      <Result bus={bus} />
      <Question bus={bus} />
    </>
  );
}

/** What became of the request that is shown, and the way to its reply. */
function Result({ bus }: SendProps) {
  const { send: words, guard } = useWords('bus');
  const current = useSteady(() => page.evaluation.value.frame?.bytes).value;
  const { value: last } = bus.last;
  const refused = bus.refused.value;
  if (bus.sending.value) return <output class="sent">{words.sending}</output>;
  if (refused) return <output class="sent">{guard.refusals[refused]}</output>;
  if (last === undefined || current === undefined || !sameBytes(last.request, current)) return null;
  const { reply, request, transport, duration, attempts } = last;
  const open = () => {
    if (reply) page.showReading(decodeFrame(reply, { transport, direction: 'response', request }), request, 'step');
  };
  return (
    <output class="sent">
      {words.result(last)} {duration !== undefined && words.took(duration, attempts)}{' '}
      {reply && (
        <button type="button" class="why-button" onClick={open}>
          {words.openReply}
        </button>
      )}
    </output>
  );
}
