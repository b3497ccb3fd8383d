import { Component } from 'preact';
import { adapterOf, rememberedPorts } from '../../bus/index.ts';
import type { Pace } from '../../workbench/index.ts';
import { Choice, optionsOf } from '../kit/choice.tsx';
import { type BusState, bus } from './bus.ts';
import { busWords as words } from './bus-words.ts';
import { RulesForm, SettingsForm } from './settings-form.tsx';
import { virtual } from './virtual-devices.ts';

interface Props {
  readonly state: BusState;
}

/** Which line this is: how it is reached, and how it stands. */
export class ConnectionPanel extends Component<Props, { readonly ports: readonly SerialPort[] }> {
  override state = { ports: [] };

  override componentDidMount() {
    if (!('serial' in navigator)) return;
    navigator.serial.addEventListener('connect', this.look);
    navigator.serial.addEventListener('disconnect', this.look);
    void this.look();
  }

  override componentWillUnmount() {
    if (!('serial' in navigator)) return;
    navigator.serial.removeEventListener('connect', this.look);
    navigator.serial.removeEventListener('disconnect', this.look);
  }

  override componentDidUpdate(before: Props) {
    if (before.state.link.kind !== this.props.state.link.kind && 'serial' in navigator) void this.look();
  }

  private readonly look = async () => this.setState({ ports: await rememberedPorts(navigator.serial) });

  render() {
    const { state } = this.props;
    const { link } = state;
    const said = words.link(link);
    const busy = link.kind === 'opening' || link.kind === 'closing' || link.kind === 'choosing';
    const open = link.kind === 'open';
    return (
      <section class="panel connection" aria-labelledby="connection">
        <h2 id="connection">{words.heading}</h2>
        <p class="link" data-link={link.kind} role="status">
          <strong>{said.is}</strong> {said.todo}
        </p>
        {state.serving && <p class="said">{words.serving}</p>}
        {state.inWindow && open && <p class="said">{words.inWindow}</p>}
        {open ? (
          <div class="actions">
            <button type="button" onClick={() => bus.disconnect()}>
              {words.disconnect}
            </button>
          </div>
        ) : (
          <Ways ports={this.state.ports} busy={busy} supported={'serial' in navigator} />
        )}
        <p class="said" aria-live="polite">
          {words.errors(state.errors)}
        </p>
        <SettingsForm settings={state.settings} open={open} />
        <RulesForm rules={state.rules} />
        {(!open || link.adapter.kind === 'virtual') && <PaceChoice />}
        {open && link.adapter.kind !== 'virtual' && <Signals state={state} />}
      </section>
    );
  }
}

interface WaysProps {
  readonly ports: readonly SerialPort[];
  readonly busy: boolean;
  readonly supported: boolean;
}

/** The ways to a line: what was chosen before first. */
function Ways({ ports, busy, supported }: WaysProps) {
  return (
    <div class="ways">
      {ports.map((port, index) => (
        <button
          key={index}
          type="button"
          class={index === 0 ? 'first' : undefined}
          disabled={busy}
          onClick={() => void bus.open(port)}
        >
          {words.remembered(adapterOf(port.getInfo()))}
        </button>
      ))}
      {supported && (
        <button
          type="button"
          class={ports.length === 0 ? 'first' : undefined}
          disabled={busy}
          onClick={() => void bus.connect()}
        >
          {ports.length === 0 ? words.connect : words.connectAgain}
        </button>
      )}
      <button type="button" class={supported ? undefined : 'first'} disabled={busy} onClick={() => virtual.open()}>
        {words.virtual}
      </button>
    </div>
  );
}

/** How fast the virtual bus goes. */
class PaceChoice extends Component {
  private readonly set = (pace: Pace) => {
    virtual.setPace(pace);
    this.forceUpdate();
  };

  render() {
    return (
      <Choice
        id="bus-pace"
        label={words.pace.label}
        value={virtual.state.pace}
        options={optionsOf(words.pace.paces)}
        onChoose={(pace) => this.set(pace)}
      />
    );
  }
}

/** The adapter's own lines, for adapters that need them set. */
function Signals({ state: { signals, signalsTaken } }: Props) {
  return (
    <details>
      <summary>{words.signals.heading}</summary>
      <div class="checks">
        {(['dtr', 'rts'] as const).map((name) => (
          <label key={name}>
            <input
              type="checkbox"
              onChange={({ currentTarget }) => bus.setSignals({ [name]: currentTarget.checked })}
            />{' '}
            {words.signals[name]}
          </label>
        ))}
      </div>
      <p class="said" aria-live="polite">
        {!signalsTaken && words.signals.refused}{' '}
        {signals && words.signals.inputs(signals.cts, signals.dsr, signals.dcd, signals.ri)}
      </p>
    </details>
  );
}
