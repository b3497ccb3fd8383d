import { quantityOf, type Table } from '../../modbus/index.ts';
import {
  type AddressConvention,
  type AddressRepair,
  type AddressTrap,
  addressMeant,
  addressTraps,
  bitOfAddress,
} from '../../notation/index.ts';
import { addressQuantity } from './address-typed.ts';
import { type Draft, withText } from './draft.ts';
import type { Evaluation } from './evaluate.ts';

/** An address of a frame: its text there, and as it was typed in the way of the manual that is chosen. */
interface AddressAt {
  readonly path: string;
  readonly text: string;
  readonly typed: string;
  readonly table: Table;
}

/** The traps that an address of a frame may be in, warnings first. */
export function trapsOf(
  { path, text, typed, table }: AddressAt,
  evaluated: Evaluation,
  convention: AddressConvention,
): readonly AddressTrap[] {
  const { description, controls } = evaluated;
  // A device's name is in no trap; the address it stands for may be.
  const asManual = typed !== text && convention !== 'protocol' && addressMeant(typed, convention, table) !== undefined;
  // The bit is in what was typed, of which the frame has the register.
  const bit = typed === text ? undefined : bitOfAddress(typed);
  const ofBit: AddressTrap = {
    code: 'bit-of-register',
    severity: 'note',
    text: typed,
    got: undefined,
    bit: bit ?? 0,
    repairs: [],
  };
  const traps = addressTraps(asManual ? typed : text, {
    functionCode: description.code,
    table,
    quantity: addressQuantity(evaluated, path),
    quantityFree: controls.some((control) => control.path === quantityOf(path) && !control.derived),
    readAs: asManual ? convention : 'protocol',
    manual: convention,
  });
  return bit === undefined || asManual ? traps : [...traps, ofBit];
}

/** The draft after a repair of the address at `path`. */
export function repaired(draft: Draft, path: string, by: AddressRepair): Draft {
  if (by.kind === 'quantity') return withText(draft, quantityOf(path) ?? path, String(by.quantity));
  const next = withText(draft, path, by.text);
  return by.kind === 'function' ? withText(next, 'functionCode', String(by.functionCode)) : next;
}
