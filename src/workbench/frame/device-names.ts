import { type Convention, nameAt, type Profile, placesNamed } from '../../devices/index.ts';
import type { Problem, Table } from '../../modbus/index.ts';

/** What a device calls what is in a frame; empty where it has no name for it. */
export interface FrameNames {
  /** Of the field of this name. */
  readonly field: (name: string) => string;
  /** The same where there is little room: `P0683` of an address, `30.0 Hz` of a value. */
  readonly short: (name: string) => string;
  /** Of an item of the list of this name, by its index from 0. */
  readonly item: (list: string, index: number) => string;
  /** How many items make the value that begins at an item; 1 where another value begins inside it, or none begins. */
  readonly covers: (list: string, index: number) => number;
  /** The address of an item, where the device does not count one for each. */
  readonly addressOf: (list: string, index: number) => number | undefined;
  /** Of a rule that the frame breaks: that the device has it so. */
  readonly departure: (problem: Problem) => string;
}

/** The registers of a device by name. */
export interface RegisterNames {
  readonly device: string;
  /** How its manual prints addresses. */
  readonly prints: Convention;
  /** The place that a name stands for, in this table if the name stands there; `undefined` for other texts. */
  readonly placeOf: (name: string, table: Table) => { readonly table: Table; readonly address: number } | undefined;
  /** What the device calls the element at an address counted from 0. */
  readonly nameAt: (table: Table, address: number) => string | undefined;
}

export const registerNamesOf = (profile: Profile): RegisterNames => ({
  device: profile.name,
  prints: profile.convention,
  placeOf: (name, table) => {
    const places = placesNamed(profile, name);
    return places.find((place) => place.table === table) ?? places[0];
  },
  nameAt: (table, address) => (table === 'file-record' ? undefined : nameAt(profile, table, address)),
});
