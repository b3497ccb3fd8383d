import type { Table } from '../../../modbus/index.ts';
import { type AddressConvention, addressConventions } from '../../../notation/index.ts';
import { addressInFrame, type Draft, type Shown, shownAt, withTyped } from '../../../workbench/index.ts';
import { device, registerNames } from '../../parts/device/naming.ts';
import { Cell } from '../../state/cell.ts';
import { Remembered } from '../../state/remembered.ts';

const remembered = new Remembered<AddressConvention>('addresses', 'protocol', (value) =>
  addressConventions.find((known) => known === value),
);

/** How the manual at hand prints addresses. */
export const convention = new Cell<AddressConvention>(remembered.value);

export function chooseConvention(chosen: AddressConvention): void {
  remembered.value = chosen;
  convention.value = chosen;
}

/** The text a frame's field gets for an address as typed, by the manual and the device that are chosen now. */
const inFrame = (typed: string, table: Table): string =>
  addressInFrame(typed, table, { convention: convention.value, names: registerNames.value });

/** What an address field shows. */
export const shownAddress = (draft: Draft, path: string, text: string, table: Table): Shown =>
  shownAt(draft, path, text, (typed) => inFrame(typed, table));

/** The draft with an address as it was typed. */
export const withAddress = (draft: Draft, path: string, typed: string, table: Table): Draft =>
  withTyped(draft, path, typed, inFrame(typed, table), device.value?.id);
