import { Component } from 'preact';
import { type DeviceSetup, sourceSetups } from '../../../bus/index.ts';
import { LAST_UNIT } from '../../../modbus/index.ts';
import { deviceKinds, kindName } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { allDevices } from '../../parts/device/chosen.ts';
import { virtual } from '../virtual-devices.ts';
import { NumberCell } from './number-cell.tsx';
import { virtualWords as words } from './virtual-words.ts';

interface ListProps {
  readonly devices: readonly DeviceSetup[];
  readonly chosen: number | undefined;
  readonly onChoose: (id: number) => void;
}

interface ListState {
  /** Of what can be added, by its place in that list. */
  readonly kind: number;
  /** The devices there were, until something else is done. */
  readonly before: readonly DeviceSetup[] | undefined;
}

/** The devices on the line, as many as anybody wants. */
export class DeviceList extends Component<ListProps, ListState> {
  override state: ListState = { kind: 0, before: undefined };

  private set(devices: readonly DeviceSetup[], before?: readonly DeviceSetup[]) {
    virtual.setDevices(devices);
    this.setState({ before });
  }

  private change(id: number, change: Partial<DeviceSetup>) {
    this.set(this.props.devices.map((device) => (device.id === id ? { ...device, ...change } : device)));
  }

  private readonly add = () => {
    const { devices, onChoose } = this.props;
    const units = new Set(devices.map(({ unit }) => unit));
    let unit = 1;
    while (units.has(unit) && unit < LAST_UNIT) unit++;
    const id = this.nextId();
    const kind = deviceKinds(allDevices().own.value)[this.state.kind];
    if (kind === undefined) return;
    this.set([...devices, { id, ...kind, unit, on: true }]);
    onChoose(id);
  };

  private nextId() {
    const all = [...this.props.devices, ...(this.state.before ?? [])];
    return 1 + Math.max(0, ...all.map(({ id }) => id));
  }

  private readonly restart = () => {
    // With numbers of their own, so that they are not taken for those there are.
    const first = this.nextId();
    const devices = sourceSetups().map((setup, index) => ({ ...setup, id: first + index }));
    this.set(devices, this.props.devices);
  };

  private readonly undo = () => {
    const { before } = this.state;
    if (before) this.set(before);
  };

  render() {
    const { devices, chosen, onChoose } = this.props;
    const { kind, before } = this.state;
    const text = words.devices;
    const units = devices.filter(({ on }) => on).map(({ unit }) => unit);
    const twice = [...new Set(units.filter((unit, index) => units.indexOf(unit) !== index))];
    return (
      <section aria-labelledby="virtual-devices">
        <h3 id="virtual-devices">{text.heading}</h3>
        <ul class="devices">
          {devices.map((device, index) => {
            const { id, unit, on } = device;
            const name = kindName(device, words.models);
            return (
              <li key={id} data-chosen={id === chosen ? '' : undefined}>
                <input
                  type="checkbox"
                  checked={on}
                  aria-label={text.on(unit)}
                  title={text.onHead}
                  onChange={({ currentTarget }) => this.change(id, { on: currentTarget.checked })}
                />
                <NumberCell
                  label={`${text.unit(name)} (${index + 1})`}
                  value={unit}
                  least={1}
                  most={LAST_UNIT}
                  wrong={text.unitWrong}
                  onChange={(unit) => this.change(id, { unit })}
                />
                <button type="button" class="name" aria-pressed={id === chosen} onClick={() => onChoose(id)}>
                  {name}
                </button>
                <button
                  type="button"
                  aria-label={text.remove(name, unit)}
                  onClick={() => this.set(devices.toSpliced(index, 1), devices)}
                >
                  {text.removeShort}
                </button>
              </li>
            );
          })}
        </ul>
        <p class="said" role="status">
          {devices.length === 0 && text.none}
          {twice.length > 0 && <span class="error">{text.twice(twice)}</span>}
        </p>
        <div class="tools">
          <label>
            {text.addWhat}{' '}
            <Select
              value={kind}
              options={deviceKinds(allDevices().own.value).map((one, value) => ({
                value,
                name: kindName(one, words.models),
              }))}
              onChoose={(chosen) => this.setState({ kind: chosen })}
            />
          </label>
          <button type="button" onClick={this.add}>
            {text.add}
          </button>
          {before && (
            <button type="button" onClick={this.undo}>
              {text.undo}
            </button>
          )}
          <button type="button" onClick={this.restart}>
            {text.restart}
          </button>
        </div>
      </section>
    );
  }
}
