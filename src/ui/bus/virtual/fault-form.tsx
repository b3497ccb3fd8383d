import { useState } from 'preact/hooks';
import type { Fault } from '../../../bus/index.ts';
import { wholeNumber } from '../../../notation/index.ts';
import { optionsOf, Select } from '../../kit/choice.tsx';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';

type Kind = Fault['kind'];

/** Faults with a number: its range, its first value, and the fault that it makes. */
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

/** The faults on request, of one device or of all. */
export function FaultForm() {
  const text = useWords('virtual').faults;
  const { virtual } = bus;
  const faults = virtual.faults.value;
  const units = [...new Set(virtual.devices.value.map((device) => device.unit))];
  const [kind, setKind] = useState<Kind>('silence');
  const [number, setNumber] = useState(0);
  const [unit, setUnit] = useState<number>();
  const [always, setAlways] = useState(false);
  return (
    <section aria-labelledby="virtual-faults">
      <h3 id="virtual-faults">{text.heading}</h3>
      <div class="tools in-row">
        <label>
          {text.kind}{' '}
          <Select
            value={kind}
            options={optionsOf<Kind>(text.kinds)}
            onChoose={(wanted) => {
              setKind(wanted);
              setNumber(isNumbered(wanted) ? NUMBERED[wanted].first : 0);
            }}
          />
        </label>
        {isNumbered(kind) && (
          <NumberEntry
            key={kind}
            label={text.parameters[kind]}
            when="finished"
            value={number}
            read={wholeNumber(NUMBERED[kind].least, NUMBERED[kind].most)}
            wrong={text.parameterWrong(NUMBERED[kind].least, NUMBERED[kind].most)}
            onValue={setNumber}
          />
        )}
        <label>
          {text.who}{' '}
          <Select
            value={unit ?? ''}
            options={[{ value: '', name: text.anyone }, ...units.map((one) => ({ value: one, name: text.unit(one) }))]}
            onChoose={(chosen) => setUnit(chosen === '' ? undefined : Number(chosen))}
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
            onChoose={(often) => setAlways(often === 'always')}
          />
        </label>
        <button
          type="button"
          onClick={() =>
            virtual.setFaults([...faults, { fault: makeFault(kind, number), unit, times: always ? undefined : 1 }])
          }
        >
          {text.add}
        </button>
      </div>
      {faults.length === 0 && <p class="said">{text.none}</p>}
      <ul class="faults">
        {faults.map((rule, index) => {
          const name = text.rule(rule.fault, rule.unit, rule.times);
          return (
            <li key={index}>
              <span>{name}</span>
              <button
                type="button"
                aria-label={text.removeThis(name)}
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
