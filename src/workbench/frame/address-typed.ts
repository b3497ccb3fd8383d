import type { Table } from '../../modbus/index.ts';
import { type AddressConvention, addressMeant, clearAddress, zeroBasedAddress } from '../../notation/index.ts';
import type { RegisterNames } from './device-names.ts';

/** What gives an address its meaning beside its own text: how the manual prints addresses, and the device's names. */
export interface AddressContext {
  readonly convention: AddressConvention;
  readonly names: RegisterNames | undefined;
}

/**
 * The text a frame's field gets for what was typed in the manual's way, or by the name that the device has for a register.
 * A frame is shared by its link, and there plain numbers count from 0 whatever manual and device its reader has: what means
 * something else is written with its table's name, as `HR108`.
 */
export function addressInFrame(typed: string, table: Table, { convention, names }: AddressContext): string {
  const named = zeroBasedAddress(typed) === undefined ? names?.placeOf(typed, table) : undefined;
  const meant = addressMeant(typed, convention, table) ?? named;
  return meant === undefined || meant.address === zeroBasedAddress(typed)
    ? typed
    : clearAddress(meant.table ?? table, meant.address);
}
