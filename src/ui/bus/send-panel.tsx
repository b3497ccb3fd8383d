import { useComputed } from '@preact/signals';
import { mbpollCommand, ncCommand, readOnlyCodes, type SentResult } from '../../bus/index.ts';
import { type Reading, sameBytes } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { BusView } from '../../store/index.ts';
import { disabledFor } from '../kit/disabled-for.ts';
import { useCommand, useKeyOf } from '../parts/commands.ts';
import { page } from '../parts/store.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

const TCP_PORT = 502;

const useFrame = () => useComputed(() => page.evaluation.value.frame).value;

/** The current frame, sent once, and in a word what came of it. */
export function SendPanel({ view }: ViewProps<BusView>) {
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
    <section class="panel send" aria-labelledby="current-frame">
      <div class="in-row">
        <h2 id="current-frame">{text.heading}</h2>
        {frame && <span>{summary(frame.reading, frame.bytes.length, transport)}</span>}
        <a href={`#${page.link.value}`}>{text.change}</a>
      </div>
      {frame && <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>}
      {why && <p class="said">{why}</p>}
      {frame && why === '' && transport === 'tcp' ? (
        <TcpCommands {...frame} />
      ) : (
        <SendButtons whyNot={why} view={view} />
      )}
      <Result view={view} />
    </section>
  );
}

function SendButtons({ whyNot, view }: ViewProps<BusView> & { readonly whyNot: string }) {
  const { send: text, guard } = useWords('bus');
  const frame = useFrame();
  const possible = whyNot === '';
  const transport = page.transport.value;
  const connected = bus.connected.value;
  const sending = bus.sending.value;
  const { tab } = view.shown.value;
  const send =
    connected && possible && !sending && frame && (transport === 'rtu' || transport === 'ascii')
      ? () => bus.send(frame.bytes, transport)
      : undefined;
  useCommand('send', send);
  const key = useKeyOf('send');
  // Of the buttons in sight one is the next to be pressed: that of the panel that is open.
  const isFirst = connected && possible && (tab === 'reply' || tab === 'no-answer');
  return (
    <div class="actions">
      <button
        type="button"
        class={isFirst ? 'first' : undefined}
        onClick={send}
        {...key}
        {...(send === undefined && disabledFor(whyNot || (connected ? text.sending : text.notConnected)))}
      >
        {text.send}
      </button>
      {sending && (
        <button type="button" class="stop" onClick={() => bus.stopAll()}>
          {text.stop}
        </button>
      )}
      {!connected && <span class="said">{text.notConnected}</span>}
      <label>
        <input
          type="checkbox"
          aria-describedby="read-only-codes"
          checked={bus.readOnly.value}
          onChange={({ currentTarget }) => bus.setReadOnly(currentTarget.checked)}
        />{' '}
        {guard.readOnly}
      </label>
      <span class="said" id="read-only-codes">
        {guard.readOnlyCodes(readOnlyCodes.all, readOnlyCodes.some)}
      </span>
    </div>
  );
}

/** Commands that send the frame from a terminal, as a page cannot. */
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

/** What became of the current frame when it was sent; nothing if another was sent last. */
function Result({ view }: ViewProps<BusView>) {
  const { send: text, guard } = useWords('bus');
  const frame = useFrame();
  const { value: asked } = bus.asked;
  const refused = bus.refused.value;
  const last = bus.last.value;
  if (asked === undefined || frame === undefined || !sameBytes(frame.bytes, asked.request)) return <Verdict is="" />;
  if (refused)
    return (
      <div class="in-row">
        <Verdict is={guard.refusals[refused]} severity="warning" />
        {refused === 'read-only' && (
          <button
            type="button"
            {...disabledFor(bus.connected.value ? undefined : text.notConnected)}
            onClick={() => bus.sendOnce()}
          >
            {guard.sendOnce}
          </button>
        )}
      </div>
    );
  if (bus.sending.value) return <Verdict is={text.sending} />;
  if (last === undefined) return <Verdict is="" />;
  const { duration, attempts, outcome } = last;
  const tab = outcome === 'silent' ? 'no-answer' : 'reply';
  return (
    <div class="in-row">
      <Verdict
        is={text.result(last)}
        severity={severityOf(last)}
        took={duration !== undefined && text.took(duration, attempts)}
        more={outcome === 'silent' && view.shown.value.tab === tab && text.stepsOpen}
      />
      {view.shown.value.tab !== tab && (
        <button type="button" onClick={() => view.open(tab)}>
          {text.show[tab]}
        </button>
      )}
    </div>
  );
}

/** How much is wrong with what became of a request. */
export const severityOf = ({ verdict }: SentResult): 'error' | 'warning' | undefined =>
  verdict === 'good' ? undefined : verdict === 'doubtful' ? 'warning' : 'error';

interface VerdictProps {
  readonly is: string;
  readonly severity?: 'error' | 'warning' | undefined;
  readonly took?: string | false;
  /** What is only read out. */
  readonly more?: string | false;
}

/** It stands also when it is empty, so that what comes is read out and moves nothing. */
const Verdict = ({ is, severity, took, more }: VerdictProps) => (
  <p class="verdict result" data-severity={severity} aria-live="polite">
    <strong>{is}</strong> {took && <span>{took}</span>} {more && <span class="unseen">{more}</span>}
  </p>
);
