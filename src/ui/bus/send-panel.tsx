import { mbpollCommand, ncCommand } from '../../bus/index.ts';
import { decodeFrame, type Reading } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { writeLink } from '../../workbench/index.ts';
import { useCommand, useKeyOf } from '../parts/commands.ts';
import { naming } from '../parts/device/naming.ts';
import { loadExplanation } from '../parts/explanation/load-explanation.tsx';
import { words as pageWords, problemText } from '../parts/page-words.ts';
import { Slot } from '../parts/slot.tsx';
import { draft, evaluation, page } from '../parts/store.ts';
import { type BusState, bus } from './bus.ts';
import { busWords as words } from './bus-words.ts';

const loadBrokenReply = () => import('./broken-reply.tsx').then(({ loadPanel }) => loadPanel());

const TCP_PORT = 502;

/** The current frame, sent once, and what came back. */
export function SendPanel({ state }: { readonly state: BusState }) {
  const { frame, controls } = evaluation.value;
  const text = words.send;
  const { transport, kind } = draft.value;
  const why =
    frame === undefined ? text.noFrame : kind !== 'request' ? text.notRequest : transport === 'pdu' ? text.pdu : '';
  return (
    <section class="panel" aria-labelledby="at-hand">
      <h2 id="at-hand">{text.heading}</h2>
      {frame && (
        <>
          <p>{pageWords.page.summary(frame.reading, frame.bytes.length, transport)}</p>
          <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>
        </>
      )}
      {why && <p class="said">{why}</p>}
      {frame && why === '' && transport === 'tcp' ? (
        <TcpCommands {...frame} />
      ) : (
        <SendButtons state={state} possible={why === ''} />
      )}
      <a href={`#${writeLink(draft.value, controls)}`}>{text.change}</a>
      <Result state={state} />
    </section>
  );
}

function SendButtons({ state, possible }: { readonly state: BusState; readonly possible: boolean }) {
  const text = words.send;
  const { frame } = evaluation.value;
  const { transport } = draft.value;
  const connected = state.link.kind === 'open';
  const sending = state.sending;
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
          checked={state.readOnly}
          onChange={({ currentTarget }) => bus.setReadOnly(currentTarget.checked)}
        />{' '}
        {words.guard.readOnly}
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
      <p>{words.send.tcp}</p>
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
function Result({ state }: { readonly state: BusState }) {
  const text = words.send;
  const { last, sending, refused } = state;
  if (refused) return <Said said={words.guard.refusals[refused]} severity="warning" />;
  if (sending) return <Said said={text.sending} />;
  if (last === undefined) return <Said said="" />;
  const { reply, request } = last;
  const { transport } = state.rules;
  const reading = reply && decodeFrame(reply, { transport, direction: 'response', request });
  const good = last.verdict === 'good';
  return (
    <>
      <Said said={text.result(last)} severity={good ? undefined : last.verdict === 'doubtful' ? 'warning' : 'error'}>
        {last.duration !== undefined && text.took(last.duration, last.attempts)}
      </Said>
      {reading && reply && (
        <>
          <p>{pageWords.page.summary(reading, reply.length, transport)}</p>
          <p class="mono bytes-line">{formatBytes(reply)}</p>
          <ul class="problems">
            {reading.problems.map((problem) => (
              <li key={`${problem.code} ${problem.span.from}`} data-severity={problem.severity}>
                <b>{pageWords.page.severities[problem.severity]}</b> {problemText(problem)}{' '}
                <span class="section">{pageWords.section(problem.section)}</span>
              </li>
            ))}
          </ul>
          <Slot part={loadExplanation} with={{ reading, bytes: reply, names: naming.value?.(reading) }} />
          <div class="actions">
            <button type="button" onClick={() => page.showReading(reading, request, 'step')}>
              {text.open}
            </button>
          </div>
        </>
      )}
      {last.findings.length > 0 && <Slot part={loadBrokenReply} with={{ findings: last.findings }} />}
      {last.unsure && <p class="said">{text.unsure[last.unsure]}</p>}
      {last.slow !== undefined && <p class="said">{text.slow(last.slow, state.rules.timeout)}</p>}
      {last.outcome === 'silent' && <p class="said">{text.silentTodo}</p>}
      {last.echo !== 'none' && <p class="said">{text.echo[last.echo]}</p>}
      {last.strays > 0 && last.echo !== 'removed' && <p class="said">{text.strays(last.strays)}</p>}
    </>
  );
}

interface SaidProps {
  readonly said: string;
  readonly severity?: 'error' | 'warning' | undefined;
  readonly children?: string | false | undefined;
}

/** It stands also when it is empty, so that what comes is read out. */
function Said({ said, severity, children }: SaidProps) {
  return (
    <p class="verdict result" data-severity={severity} aria-live="polite">
      <strong>{said}</strong> {children && <span>{children}</span>}
    </p>
  );
}
