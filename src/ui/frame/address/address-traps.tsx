import type { Table } from '../../../modbus/index.ts';
import type { AddressTrap } from '../../../notation/index.ts';
import { repaired, trapsOf } from '../../../workbench/index.ts';
import { useSteady } from '../../parts/steady.ts';
import { draft, evaluation, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { addresses } from './convention.ts';
import './address-ways.css';

interface TrapsProps {
  readonly path: string;
  /** What the frame's field has. */
  readonly text: string;
  readonly table: Table;
  readonly severity: AddressTrap['severity'];
}

/** The traps of one severity that an address may be in, each with its repairs. */
export function Traps({ path, text, table, severity }: TrapsProps) {
  const words = useWords('addressWays');
  const traps = useSteady(() => {
    const typed = addresses.shown(draft.value, path, text, table).text;
    return trapsOf({ path, text, typed, table }, evaluation.value, addresses.convention.value);
  }, [path, text, table]).value;
  return traps
    .filter((trap) => trap.severity === severity)
    .map((trap) => (
      <div key={trap.code} class="trap edged" data-severity={severity}>
        <p>{words.trap(trap)}</p>
        {trap.repairs.map((by) => (
          <button key={words.repair(by)} type="button" onClick={() => step(repaired(draft.value, path, by))}>
            {words.repair(by)}
          </button>
        ))}
      </div>
    ));
}
