import { useComputed } from '@preact/signals';
import { mbpollCommand, ncCommand } from '../../bus/index.ts';
import type { Reading } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { useCommand, useKeyOf } from '../parts/commands.ts';
import { part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

const sentReply = part(
  ['complaints', 'tools'],
  () => import('./sent-reply.tsx'),
  ({ SentReply }) => SentReply,
);
const replyFindings = part(
  ['findings'],
  () => import('./sent-reply.tsx'),
  ({ ReplyFindings }) => ReplyFindings,
);

const TCP_PORT = 502;

const useFrame = () => useComputed(() => page.evaluation.value.frame).value;

/** The current frame, sent once, and what came back. */
export function SendPanel() {
  const text = useWords('bus').send;
  const { summary } = useWords('page').page;
  const frame = useFrame();
  const transport = page.transport.value;
  const why =
    frame === undefined
      ? text.noFrame
      : page.kind.value !== 'request'
        ? text.notRequest
        : transport === 'pdu'
          ? text.pdu
          : '';
  return (
    <section class="panel" aria-labelledby="current-frame">
      <h2 id="current-frame">{text.heading}</h2>
      {frame && (
        <>
          <p>{summary(frame.reading, frame.bytes.length, transport)}</p>
          <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>
        </>
      )}
      {why && <p class="said">{why}</p>}
      {frame && why === '' && transport === 'tcp' ? <TcpCommands {...frame} /> : <SendButtons possible={why === ''} />}
      <a href={`#${page.link.value}`}>{text.change}</a>
      <Result />
    </section>
  );
}

function SendButtons({ possible }: { readonly possible: boolean }) {
  const { send: text, guard } = useWords('bus');
  const frame = useFrame();
  const transport = page.transport.value;
  const connected = bus.connected.value;
  const sending = bus.sending.value;
  const send =
    connected && possible && !sending && frame && (transport === 'rtu' || transport === 'ascii')
      ? () => bus.send(frame.bytes, transport)
      : undefined;
  useCommand('send', send);
  return (
    <div class="actions">
      <button type="button" class="first" disabled={send === undefined} onClick={send} {...useKeyOf('send')}>
        {text.send}
      </button>
      {sending && (
        <button type="button" onClick={() => bus.stopAll()}>
          {text.stop}
        </button>
      )}
      <label>
        <input
          type="checkbox"
          checked={bus.readOnly.value}
          onChange={({ currentTarget }) => bus.setReadOnly(currentTarget.checked)}
        />{' '}
        {guard.readOnly}
      </label>
      {!connected && <span class="said">{text.notConnected}</span>}
    </div>
  );
}

function TcpCommands({ reading, bytes }: { readonly reading: Reading; readonly bytes: Uint8Array }) {
  const host = '192.168.0.10';
  const commands = [mbpollCommand(reading, host), ncCommand(bytes, host, TCP_PORT)];
  return (
    <>
      <p>{useWords('bus').send.tcp}</p>
      {commands.map(
        (command) =>
          command !== undefined && (
            <pre key={command} class="mono command">
              {command}
            </pre>
          ),
      )}
    </>
  );
}

/** What became of the last request; it stands while nothing else is sent. */
function Result() {
  const { send: text, guard } = useWords('bus');
  const refused = bus.refused.value;
  const last = bus.last.value;
  if (refused) return <Verdict is={guard.refusals[refused]} severity="warning" />;
  if (bus.sending.value) return <Verdict is={text.sending} />;
  if (last === undefined) return <Verdict is="" />;
  const { verdict, duration, attempts, reply, request, findings, unsure, slow, outcome, echo, strays } = last;
  return (
    <>
      <Verdict
        is={text.result(last)}
        severity={verdict === 'good' ? undefined : verdict === 'doubtful' ? 'warning' : 'error'}
        took={duration !== undefined && text.took(duration, attempts)}
      />
      {reply && <Slot part={sentReply} with={{ request, reply }} />}
      {findings.length > 0 && <Slot part={replyFindings} with={{ findings }} />}
      {unsure && <p class="said">{text.unsure[unsure]}</p>}
      {slow !== undefined && <p class="said">{text.slow(slow, bus.rules.value.timeout)}</p>}
      {outcome === 'silent' && <p class="said">{text.silentTodo}</p>}
      {echo !== 'none' && <p class="said">{text.echo[echo]}</p>}
      {strays > 0 && echo !== 'removed' && <p class="said">{text.strays(strays)}</p>}
    </>
  );
}

interface VerdictProps {
  readonly is: string;
  readonly severity?: 'error' | 'warning' | undefined;
  readonly took?: string | false;
}

/** It stands also when it is empty, so that what comes is read out. */
const Verdict = ({ is, severity, took }: VerdictProps) => (
  <p class="verdict result" data-severity={severity} aria-live="polite">
    <strong>{is}</strong> {took && <span>{took}</span>}
  </p>
);
