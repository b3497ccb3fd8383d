import type { Table } from '../../modbus/index.ts';
import {
  type AddressConvention,
  addressConventions,
  addressMeant,
  clearAddress,
  zeroBasedAddress,
} from '../../notation/index.ts';
import { Cell } from '../cell.ts';
import { registerNames } from '../device/naming.ts';
import { Remembered } from '../tools/remembered.ts';
import { takeTyped, typedText } from '../typed-texts.ts';

const remembered = new Remembered<AddressConvention>('addresses', 'protocol', (value) =>
  addressConventions.find((known) => known === value),
);

/** How the manual at hand prints addresses. */
export const convention = new Cell<AddressConvention>(remembered.value);

export function chooseConvention(chosen: AddressConvention): void {
  remembered.value = chosen;
  convention.value = chosen;
}

/**
 * The text a frame's field gets for what was typed in the manual's way, or by the name that the chosen device has for a
 * register. A frame is shared by its link, and there plain numbers count from 0 whatever manual and device its reader has:
 * what means something else is written with its table's name.
 */
function inFrame(typed: string, table: Table): string {
  const named = zeroBasedAddress(typed) === undefined ? registerNames.value?.placeOf(typed, table) : undefined;
  const meant = addressMeant(typed, convention.value, table) ?? named;
  return meant === undefined || meant.address === zeroBasedAddress(typed)
    ? typed
    : clearAddress(meant.table ?? table, meant.address);
}

/** What was typed in a field in the manual's way, as long as the field still has what was made of it. */
export const typedIn = (path: string, text: string, table: Table): string | undefined =>
  typedText(path, text, (typed) => inFrame(typed, table));

/** Keeps what is typed in a field in the manual's way, and answers the text the field gets. */
export const typeIn = (path: string, typed: string, table: Table): string =>
  takeTyped(path, typed, (text) => inFrame(text, table));
