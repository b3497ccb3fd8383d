import { Component } from 'preact';
import type { DeviceSetup, Fault, FaultRule } from '../../../bus/index.ts';
import { optionsOf, Select } from '../../kit/choice.tsx';
import { virtual } from '../virtual-devices.ts';
import { NumberCell } from './number-cell.tsx';
import { virtualWords as words } from './virtual-words.ts';

type Kind = Fault['kind'];

/** Faults with a number of their own: what it can be, what it begins with, and what it makes. */
const NUMBERED = {
  late: { least: 1, most: 60_000, first: 1500, make: (by: number): Fault => ({ kind: 'late', by }) },
  exception: {
    least: 1,
    most: 255,
    first: 4,
    make: (exceptionCode: number): Fault => ({ kind: 'exception', exceptionCode }),
  },
  'cut-off': { least: 1, most: 512, first: 4, make: (keep: number): Fault => ({ kind: 'cut-off', keep }) },
  noise: { least: 1, most: 64, first: 3, make: (bytes: number): Fault => ({ kind: 'noise', bytes }) },
} as const;
type Numbered = keyof typeof NUMBERED;

const isNumbered = (kind: Kind): kind is Numbered => Object.hasOwn(NUMBERED, kind);
const makeFault = (kind: Kind, number: number): Fault => (isNumbered(kind) ? NUMBERED[kind].make(number) : { kind });

interface FaultProps {
  readonly devices: readonly DeviceSetup[];
  readonly faults: readonly FaultRule[];
}

interface FaultState {
  readonly kind: Kind;
  readonly number: number;
  readonly unit: number | undefined;
  readonly always: boolean;
}

/** What is to go wrong, for a device or for all of them. */
export class FaultForm extends Component<FaultProps, FaultState> {
  override state: FaultState = { kind: 'silence', number: 0, unit: undefined, always: false };

  private readonly add = () => {
    const { kind, number, unit, always } = this.state;
    virtual.setFaults([...this.props.faults, { fault: makeFault(kind, number), unit, times: always ? undefined : 1 }]);
  };

  render() {
    const { devices, faults } = this.props;
    const { kind, number, unit, always } = this.state;
    const text = words.faults;
    const units = [...new Set(devices.map((device) => device.unit))];
    return (
      <section aria-labelledby="virtual-faults">
        <h3 id="virtual-faults">{text.heading}</h3>
        <div class="tools">
          <label>
            {text.what}{' '}
            <Select
              value={kind}
              options={optionsOf<Kind>(text.kinds)}
              onChoose={(wanted) =>
                this.setState({ kind: wanted, number: isNumbered(wanted) ? NUMBERED[wanted].first : 0 })
              }
            />
          </label>
          {isNumbered(kind) && (
            <NumberCell
              key={kind}
              label={text.parameters[kind]}
              shown
              value={number}
              least={NUMBERED[kind].least}
              most={NUMBERED[kind].most}
              wrong={text.parameterWrong(NUMBERED[kind].least, NUMBERED[kind].most)}
              onChange={(number) => this.setState({ number })}
            />
          )}
          <label>
            {text.who}{' '}
            <Select
              value={unit ?? ''}
              options={[
                { value: '', name: text.anyone },
                ...units.map((one) => ({ value: one, name: text.unit(one) })),
              ]}
              onChoose={(chosen) => this.setState({ unit: chosen === '' ? undefined : Number(chosen) })}
            />
          </label>
          <label>
            {text.often}{' '}
            <Select
              value={always ? 'always' : 'once'}
              options={[
                { value: 'once', name: text.once },
                { value: 'always', name: text.always },
              ]}
              onChoose={(often) => this.setState({ always: often === 'always' })}
            />
          </label>
          <button type="button" onClick={this.add}>
            {text.add}
          </button>
        </div>
        {faults.length === 0 && <p class="said">{text.none}</p>}
        <ul class="faults">
          {faults.map((rule, index) => {
            const said = text.rule(rule.fault, rule.unit, rule.times);
            return (
              <li key={index}>
                <span>{said}</span>
                <button
                  type="button"
                  aria-label={text.removeThis(said)}
                  onClick={() => virtual.setFaults(faults.toSpliced(index, 1))}
                >
                  {text.remove}
                </button>
              </li>
            );
          })}
        </ul>
      </section>
    );
  }
}
