import { counterpart, describeFunction, functionsOf, LAST_ADDRESS, type Table, tableDigits } from '../modbus/index.ts';
import { plainAddress } from './address-forms.ts';
import { type AddressConvention, type AddressMeaning, addressMeant } from './address-meanings.ts';
import { clearAddress, clearProtocolAddress } from './clear-address.ts';
import type { PlcCode } from './plc-devices.ts';
import { bitOfAddress, readAddress } from './read-address.ts';

/** What can be done about a trap: another text for the field, perhaps with another function, or a smaller quantity. */
export type AddressRepair =
  | { readonly kind: 'text'; readonly text: string; readonly address: number }
  | { readonly kind: 'function'; readonly text: string; readonly address: number; readonly functionCode: number }
  | { readonly kind: 'quantity'; readonly quantity: number };

/**
 * What each trap knows, by its code. `got` is the address the text is read as, from 0, if it is one; `address` the other one
 * that may be meant.
 */
export interface AddressTrapData {
  /** A number of five digits, read as an address from 0. */
  readonly 'number-as-address': { got: number | undefined; table: Table; address: number };
  /** An address of another table than the function's. */
  readonly 'other-table': { named: Table; table: Table; address: number; functions: readonly number[] };
  /** Read from 0, though it may be a number from 1. */
  readonly 'counted-from-one': { got: number; address: number };
  /** Read as a number from 1, though it may be an address from 0. */
  readonly 'counted-from-zero': { got: number; address: number };
  /** The table's digit may stand before an address from 0. */
  readonly 'digit-from-zero': { got: number | undefined; table: Table; address: number };
  /** The table's digit may stand before a number from 1. */
  readonly 'digit-from-one': { got: number; table: Table; address: number };
  /** Counted on from 49999 or 19999, where five digits end and six begin. */
  readonly 'past-five-digits': { got: number | undefined; table: Table; address: number };
  /** `0x` is hexadecimal, or the coils' prefix. */
  readonly 'coil-or-hex': { got: number | undefined; address: number };
  /** Zeros in front, which mean nothing or are the digit of the coils: then `address` is that coil's. */
  readonly 'leading-zeros': { got: number | undefined; address: number | undefined };
  /** Numbers begin with 1. */
  readonly 'number-zero': { got: number | undefined; table: Table };
  /** Address and quantity go beyond the last address (AP 4.4). */
  readonly 'over-end': { got: number; quantity: number };
  /** A bit of a register, which is read and written as a whole (AP 6.3). */
  readonly 'bit-of-register': { got: number | undefined; bit: number };
  /** A point or comma that may group digits: then it is `address`. */
  readonly 'grouped-digits': { got: number; address: number };
  /** The name of a device inside a controller, whose address depends on the controller. */
  readonly 'plc-device': { got: number | undefined; plc: PlcCode; table: Table; address: number };
  /** Read as counted from 0, though the chosen manual means something else by it. */
  readonly 'not-as-in-manual': { got: number; address: number };
}

export type AddressTrapCode = keyof AddressTrapData;

/** A trap that a text may be in, with its repairs, the likeliest first. A note is worth knowing; a warning needs a look. */
export type AddressTrap = {
  [C in AddressTrapCode]: {
    readonly code: C;
    readonly severity: 'warning' | 'note';
    readonly text: string;
    readonly repairs: readonly AddressRepair[];
  } & Readonly<AddressTrapData[C]>;
}[AddressTrapCode];

/** Where an address is typed. */
export interface AddressPlace {
  readonly functionCode: number;
  /** The function's table. */
  readonly table: Table;
  /** How many items are asked for from this address on, if that is known. */
  readonly quantity?: number | undefined;
  /** Whether another quantity can be asked for, rather than follow from a list of values. */
  readonly quantityFree?: boolean;
  /** How plain numbers are read here. */
  readonly readAs?: AddressConvention;
  /** How the chosen manual means them. */
  readonly manual?: AddressConvention;
}

type Found = (
  severity: 'warning' | 'note',
  data: { [C in AddressTrapCode]: { code: C } & AddressTrapData[C] }[AddressTrapCode],
  repairs: readonly (AddressRepair | undefined)[],
) => void;

/** The traps of a text that is typed as an address, warnings first. Never throws; at most a few. */
export function addressTraps(text: string, place: AddressPlace): readonly AddressTrap[] {
  const { table, readAs = 'protocol', manual = readAs, quantity = 1 } = place;
  const typed = text.trim();
  const traps: AddressTrap[] = [];
  const found: Found = (severity, data, repairs) => {
    const those = repairs.filter((repair) => repair !== undefined);
    traps.push({ ...data, severity, text: typed, repairs: those } as AddressTrap);
  };
  const taken = addressMeant(typed, readAs, table);
  const got = taken?.address;
  const inManual = readAs === 'protocol' && manual !== readAs ? addressMeant(typed, manual, table) : undefined;
  if (got !== undefined && inManual && inManual.address !== got) {
    const { address } = inManual;
    const repairs = [textRepair(clearAddress(table, got), got), repairTo(inManual, place)];
    found('warning', { code: 'not-as-in-manual', got, address }, repairs);
  } else {
    for (const meaning of readAddress(typed, readAs, table)) {
      if (meaning !== taken && meaning.address !== got) otherwise(typed, taken, meaning, place, found);
    }
    byShape(plainAddress(typed), got, place, found);
    const bit = bitOfAddress(typed);
    if (bit !== undefined) found('note', { code: 'bit-of-register', got, bit }, []);
  }
  if (taken?.table && taken.table !== table) {
    const { table: named, address } = taken;
    const functions = functionsOf(named).map(({ code }) => code);
    const repairs = [repairTo(taken, place), textRepair(clearAddress(table, address), address)];
    found('warning', { code: 'other-table', named, table, address, functions }, repairs);
  }
  if (got !== undefined && got + quantity - 1 > LAST_ADDRESS) {
    const room = LAST_ADDRESS + 1 - got;
    const repairs = place.quantityFree ? [{ kind: 'quantity', quantity: room } as const] : [];
    found('warning', { code: 'over-end', got, quantity }, repairs);
  }
  return traps.sort((one, other) => Number(one.severity === 'note') - Number(other.severity === 'note'));
}

const textRepair = (text: string, address: number): AddressRepair => ({ kind: 'text', text, address });

/** Keeps the address a text is read as, in a way that is read as nothing else. */
const keep = ({ table, readAs = 'protocol' }: AddressPlace, got: number | undefined) =>
  got === undefined
    ? undefined
    : textRepair((readAs === 'protocol' ? clearProtocolAddress : clearAddress)(table, got), got);

/** The repair that makes a meaning the frame's: the text alone, or with the function of its table, if there is one. */
function repairTo({ table = 'holding-register', address }: AddressMeaning, place: AddressPlace) {
  const text = clearAddress(table, address);
  if (table === place.table) return textRepair(text, address);
  const other = counterpart(place.functionCode, table);
  return other && ({ kind: 'function', text, address, functionCode: other.code } as const);
}

/** What another meaning than that taken may be a trap of. */
function otherwise(
  typed: string,
  taken: AddressMeaning | undefined,
  meaning: AddressMeaning,
  place: AddressPlace,
  found: Found,
): void {
  const { table, readAs = 'protocol' } = place;
  const { address } = meaning;
  const got = taken?.address;
  const repair = repairTo(meaning, place);
  const named = meaning.table ?? table;
  const fromZero = textRepair(clearProtocolAddress(table, address), address);
  switch (meaning.notation) {
    case 'five-digit':
    case 'six-digit':
      if (repair === undefined || !alike(place.functionCode, repair)) return;
      if (typed.startsWith('0')) found('warning', { code: 'leading-zeros', got, address }, [repair, keep(place, got)]);
      else if (readAs === 'protocol' || readAs === 'one-based')
        found('warning', { code: 'number-as-address', got, table: named, address }, [repair, keep(place, got)]);
      else if (got !== undefined) found('note', { code: 'digit-from-one', got, table: named, address }, [repair]);
      return;
    case 'prefix':
      // Four digits are all that an address has in hexadecimal; the fifth can only be a coil's.
      found(/^0x\d{5}/i.test(typed) ? 'warning' : 'note', { code: 'coil-or-hex', got, address }, [
        repair,
        keep(place, got),
      ]);
      return;
    case 'hex':
      found('note', { code: 'coil-or-hex', got, address }, [fromZero]);
      return;
    case 'number':
      if (taken?.notation === 'decimal' && meaning.address === taken.address - 1)
        found('note', { code: 'counted-from-one', got: taken.address, address }, [repair]);
      return;
    case 'decimal':
      if (got !== undefined && /[.,]/.test(typed))
        found('warning', { code: 'grouped-digits', got, address }, [fromZero, keep(place, got)]);
      else if (got !== undefined) found('note', { code: 'counted-from-zero', got, address }, [fromZero]);
      return;
    case 'digit-from-zero':
      if (named === table) found('note', { code: 'digit-from-zero', got, table, address }, [repair]);
      return;
    case 'plc':
      if (meaning.plc) found('note', { code: 'plc-device', got, plc: meaning.plc, table: named, address }, [repair]);
      return;
    case 'letters':
    case 'iec':
      return;
  }
}

/** Whether a repair stays with the function, or goes to one that reads the same kind of item. */
function alike(code: number, repair: AddressRepair): boolean {
  if (repair.kind !== 'function') return true;
  return describeFunction(code, 'request').group === describeFunction(repair.functionCode, 'request').group;
}

/** First digits that a person gets by counting on where five digits end. */
const BEYOND: Readonly<Partial<Record<Table, RegExp>>> = {
  'discrete-input': /^2\d{4}$/,
  'holding-register': /^5\d{4}$/,
};

/** Traps that no meaning tells, but the digits do. */
function byShape(typed: string, got: number | undefined, place: AddressPlace, found: Found): void {
  const { table, readAs = 'protocol' } = place;
  if (BEYOND[table]?.test(typed)) {
    const address = Number(typed) - Number(`${tableDigits[table]}0001`);
    const severity = readAs === 'protocol' ? 'note' : 'warning';
    const repairs = [textRepair(clearAddress(table, address), address), keep(place, got)];
    found(severity, { code: 'past-five-digits', got, table, address }, repairs);
  }
  const zero = new RegExp(`^${tableDigits[table]}0{4,5}$`).test(typed) || (readAs === 'one-based' && typed === '0');
  if (zero && table !== 'file-record') {
    const repairs = [textRepair(clearAddress(table, 0), 0), typed === '0' ? undefined : keep(place, got)];
    found('warning', { code: 'number-zero', got, table }, repairs);
  }
  if (table !== 'coil' && /^0\d+$/.test(typed)) {
    found('note', { code: 'leading-zeros', got, address: undefined }, [keep(place, got)]);
  }
}
