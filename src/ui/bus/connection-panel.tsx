import { useEffect, useRef, useState } from 'preact/hooks';
import { adapterOf, isSameLine } from '../../bus/index.ts';
import { Choice, optionsOf } from '../kit/choice.tsx';
import { disabledFor } from '../kit/disabled-for.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';
import { RulesForm, SettingsForm } from './settings-form.tsx';

/** Which line this is: how it is reached, and how it stands. Once connected it is a line of text, until it is to be changed. */
export function ConnectionPanel() {
  const words = useWords('bus');
  const [changing, change] = useState(false);
  const link = bus.link.value;
  const isOpen = link.kind === 'open';
  const isPort = isOpen && link.adapter.kind !== 'virtual';
  const toChange = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (!isOpen) change(false);
    // The button that connected is gone, and the focus with it.
    else if (document.activeElement === document.body) toChange.current?.focus({ preventScroll: true });
  }, [isOpen]);
  return (
    <section class="panel connection" aria-labelledby="connection">
      <h2 id="connection" class={isOpen ? 'unseen' : undefined}>
        {words.heading}
      </h2>
      <div class="in-row">
        <LinkStatus />
        {isOpen && (
          <>
            <button type="button" onClick={() => bus.disconnect()}>
              {words.disconnect}
            </button>
            <button ref={toChange} type="button" aria-expanded={changing} onClick={() => change(!changing)}>
              {words.change}
            </button>
          </>
        )}
      </div>
      {isOpen && !isSameLine(link.settings, bus.settings.value) && <OtherSettings />}
      {!isOpen && (
        <Ways
          busy={
            link.kind === 'opening' || link.kind === 'closing' || link.kind === 'choosing'
              ? words.link(link).is
              : undefined
          }
        />
      )}
      <LineErrors />
      {(!isOpen || changing) && (
        <div class="forms">
          <SettingsForm />
          <RulesForm />
          {!isPort && (
            <Choice
              id="bus-pace"
              label={words.pace.label}
              value={bus.pace.value}
              options={optionsOf(words.pace.paces)}
              onChoose={(pace) => bus.setPace(pace)}
            />
          )}
          {isPort && <Signals />}
        </div>
      )}
    </section>
  );
}

function LinkStatus() {
  const words = useWords('bus');
  const link = bus.link.value;
  const { is, todo } = words.link(link);
  return (
    <div class="standing">
      <p class="link" data-link={link.kind} role="status">
        <strong>{is}</strong> {todo}
      </p>
      {bus.serving.value && <p class="said">{words.serving}</p>}
      {bus.inWindow.value && link.kind === 'open' && <p class="said">{words.inWindow}</p>}
    </div>
  );
}

/** The line is open as it was set before. */
function OtherSettings() {
  const { settings } = useWords('bus');
  return (
    <p class="in-row later">
      <span>{settings.later(bus.settings.value)}</span>
      <button type="button" onClick={() => bus.reconnect()}>
        {settings.now}
      </button>
    </p>
  );
}

/** The ways to a line: what was chosen before first. */
function Ways({ busy }: { readonly busy: string | undefined }) {
  const words = useWords('bus');
  const ports = bus.ports.value;
  const way = (first: boolean, name: string, go: () => unknown) => (
    <button type="button" class={first ? 'first' : undefined} {...disabledFor(busy)} onClick={go}>
      {name}
    </button>
  );
  return (
    <div class="in-row ways">
      {ports.map((port, index) => way(index === 0, words.remembered(adapterOf(port.getInfo())), () => bus.open(port)))}
      {bus.hasSerial &&
        way(ports.length === 0, ports.length === 0 ? words.connect : words.connectAgain, () => bus.connect())}
      {way(!bus.hasSerial, words.virtual, () => bus.openVirtual())}
    </div>
  );
}

const LineErrors = () => (
  <p class="said" aria-live="polite">
    {useWords('bus').errors(bus.errors.value)}
  </p>
);

/** The adapter's own lines, for adapters that need them set. */
function Signals() {
  const words = useWords('bus').signals;
  const { inputs, taken } = bus.signals.value;
  return (
    <details>
      <summary>{words.heading}</summary>
      <div class="checks in-row">
        {(['dtr', 'rts'] as const).map((name) => (
          <label key={name}>
            <input
              type="checkbox"
              onChange={({ currentTarget }) => bus.setSignals({ [name]: currentTarget.checked })}
            />{' '}
            {words[name]}
          </label>
        ))}
      </div>
      <p class="said" aria-live="polite">
        {!taken && words.refused} {inputs && words.inputs(inputs.cts, inputs.dsr, inputs.dcd, inputs.ri)}
      </p>
    </details>
  );
}
