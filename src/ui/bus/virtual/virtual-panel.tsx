import { Component } from 'preact';
import type { SerialMode } from '../../../modbus/index.ts';
import { Select } from '../../kit/choice.tsx';
import { bus } from '../bus.ts';
import { virtual } from '../virtual-devices.ts';
import { CellsView } from './cells-view.tsx';
import { DeviceList } from './device-list.tsx';
import { FaultForm } from './fault-form.tsx';
import { HeardList } from './heard-list.tsx';
import { virtualWords as words } from './virtual-words.ts';

/** The virtual devices: which there are, what stands in them, what goes wrong, and who hears what. */
export class VirtualPanel extends Component<object, { readonly chosen: number | undefined }> {
  override state = { chosen: virtual.state.devices[0]?.id };
  private stops: readonly (() => void)[] = [];

  override componentDidMount() {
    const draw = () => this.forceUpdate();
    let { link, serving, rules } = bus.state;
    // Of a busy line, only what is said here is drawn again.
    const look = () => {
      const { state } = bus;
      if (state.link === link && state.serving === serving && state.rules === rules) return;
      ({ link, serving, rules } = state);
      draw();
    };
    this.stops = [virtual.listen(draw), bus.listen(look)];
  }

  override componentWillUnmount() {
    for (const stop of this.stops) stop();
    virtual.watch(undefined);
  }

  render() {
    const { devices, lost, faults, frames, cells } = virtual.state;
    const { link, serving, rules } = bus.state;
    const open = link.kind === 'open';
    const isVirtual = open && link.adapter.kind === 'virtual';
    const chosen = devices.find(({ id }) => id === this.state.chosen) ?? devices[0];
    return (
      <div class="virtual">
        <p class="said">{words.intro}</p>
        <ServeBox serving={serving} possible={open && !isVirtual} mode={rules.transport} />
        {lost > 0 && <p class="said error">{words.lost(lost)}</p>}
        <DeviceList devices={devices} chosen={chosen?.id} onChoose={(chosen) => this.setState({ chosen })} />
        {chosen && <CellsView key={chosen.id} device={chosen} cells={cells} live={isVirtual || serving} />}
        <FaultForm devices={devices} faults={faults} />
        <HeardList devices={devices} frames={frames} />
      </div>
    );
  }
}

interface ServeProps {
  readonly serving: boolean;
  readonly possible: boolean;
  readonly mode: SerialMode;
}

/** The devices on the port that is connected. */
function ServeBox({ serving, possible, mode }: ServeProps) {
  const text = words.serve;
  const setMode = (transport: SerialMode) => bus.setRules({ ...bus.state.rules, transport });
  return (
    <section aria-labelledby="virtual-serve">
      <h3 id="virtual-serve">{text.heading}</h3>
      <div class="actions">
        <button type="button" disabled={!possible} onClick={() => virtual.serve(!serving)}>
          {serving ? text.stop : text.start}
        </button>
        <label>
          {text.mode}{' '}
          <Select
            value={mode}
            options={[
              { value: 'rtu', name: 'RTU' },
              { value: 'ascii', name: 'ASCII' },
            ]}
            onChoose={setMode}
          />
        </label>
      </div>
      <p class="said" role="status">
        {serving ? text.on : possible ? '' : text.notPort}
      </p>
      <p class="said">{possible && text.latency}</p>
    </section>
  );
}
