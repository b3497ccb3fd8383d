import { adapterOf } from '../../bus/index.ts';
import { Choice, optionsOf } from '../kit/choice.tsx';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';
import { RulesForm, SettingsForm } from './settings-form.tsx';

/** Which line this is: how it is reached, and how it stands. */
export function ConnectionPanel() {
  const words = useWords('bus');
  const link = bus.link.value;
  const isPort = link.kind === 'open' && link.adapter.kind !== 'virtual';
  return (
    <section class="panel connection" aria-labelledby="connection">
      <h2 id="connection">{words.heading}</h2>
      <LinkStatus />
      {link.kind === 'open' ? (
        <div class="actions">
          <button type="button" onClick={() => bus.disconnect()}>
            {words.disconnect}
          </button>
        </div>
      ) : (
        <Ways busy={link.kind === 'opening' || link.kind === 'closing' || link.kind === 'choosing'} />
      )}
      <LineErrors />
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
    </section>
  );
}

function LinkStatus() {
  const words = useWords('bus');
  const link = bus.link.value;
  const { is, todo } = words.link(link);
  return (
    <>
      <p class="link edged" data-link={link.kind} role="status">
        <strong>{is}</strong> {todo}
      </p>
      {bus.serving.value && <p class="said">{words.serving}</p>}
      {bus.inWindow.value && link.kind === 'open' && <p class="said">{words.inWindow}</p>}
    </>
  );
}

/** The ways to a line: what was chosen before first. */
function Ways({ busy }: { readonly busy: boolean }) {
  const words = useWords('bus');
  const ports = bus.ports.value;
  const way = (first: boolean, name: string, go: () => unknown) => (
    <button type="button" class={first ? 'first' : undefined} disabled={busy} onClick={go}>
      {name}
    </button>
  );
  return (
    <div class="stack ways">
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
