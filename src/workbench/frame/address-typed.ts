import { fieldValue, LAST_ADDRESS, quantityOf, type Table, tableDigits } from '../../modbus/index.ts';
import {
  type AddressConvention,
  addressMeant,
  clearAddress,
  clearProtocolAddress,
  plainAddress,
  readNumber,
  zeroBasedAddress,
} from '../../notation/index.ts';
import type { RegisterNames } from './device-names.ts';
import { type Draft, withText } from './draft.ts';
import { type Control, type Evaluation, evaluate } from './evaluate.ts';
import { typedAt, withTyped } from './typed.ts';

/** What gives an address its meaning beside its own text: how the manual prints addresses, and the device's names. */
export interface AddressContext {
  readonly convention: AddressConvention;
  readonly names: RegisterNames | undefined;
}

export const firstAddressContext: AddressContext = { convention: 'protocol', names: undefined };

/**
 * The text a frame's field gets for what was typed in the manual's way, or by the name that the device has for a register.
 * A frame is shared by its link, and there plain numbers count from 0 whatever manual and device its reader has: what means
 * something else is written with its table's name, as `HR108`. A number of five digits that begins with the digit of the
 * function's table is the number that manuals print, unless the convention or the device says otherwise (PI ch. 2).
 */
export function addressInFrame(typed: string, table: Table, context: AddressContext): string {
  const range = addressRange(typed, table, context);
  return range ? clearAddress(table, range.address) : singleInFrame(typed, table, context);
}

function singleInFrame(typed: string, table: Table, context: AddressContext): string {
  const { convention, names } = context;
  const printed = printedAs(typed, table, context);
  if (printed) return printed.which === 'number' ? clearAddress(table, printed.number) : typed;
  const named = zeroBasedAddress(typed) === undefined ? names?.placeOf(typed, table) : undefined;
  const meant = addressMeant(typed, convention, table) ?? named;
  return meant === undefined || meant.address === zeroBasedAddress(typed)
    ? typed
    : clearAddress(meant.table ?? table, meant.address);
}

/** The two things that a text like `40108` may be, as addresses counted from 0, and which it is taken for. */
interface Printed {
  readonly number: number;
  readonly address: number;
  readonly which: AddressReading;
  /** Whether the convention or the device says so. */
  readonly decided: boolean;
}

export type AddressReading = 'number' | 'address';

const PRINTED = /^[134]\d{4}$/;

/** How a number as manuals print it is taken; `undefined` for any other text, and where the manual's way is chosen. */
function printedAs(typed: string, table: Table, { convention, names }: AddressContext): Printed | undefined {
  const text = plainAddress(typed.trim());
  if (convention !== 'protocol' || !PRINTED.test(text) || text[0] !== tableDigits[table]) return undefined;
  const [address, number] = [Number(text), Number(text.slice(1)) - 1];
  if (number < 0) return undefined;
  const both = { number, address };
  const named = names?.placeOf(text, table)?.address;
  if (named === number || names?.prints === 'five-digit') return { ...both, which: 'number', decided: true };
  if (names?.prints === 'zero-based' && names.nameAt(table, address) !== undefined)
    return { ...both, which: 'address', decided: true };
  return { ...both, which: 'number', decided: false };
}

/** A range of addresses as typed (`401000–401003`, `40108..40110`): its first address, from 0, and how many there are. */
export interface AddressRange {
  readonly address: number;
  readonly quantity: number;
}

const RANGE = /^(.*?\w)\s*(?:\.\.\.?|…|[-–—~～〜]|\bto\b|\bbis\b|至)\s*(\w.*)$/i;

/** Reads a range; `undefined` for any other text, and if it ends before it begins. */
export function addressRange(typed: string, table: Table, context: AddressContext): AddressRange | undefined {
  // `4-0108` is one number with its table's digit.
  const [, first, last] = plainAddress(typed) === typed ? (RANGE.exec(typed.trim()) ?? []) : [];
  if (first === undefined || last === undefined || context.names?.placeOf(typed, table)) return undefined;
  const at = (text: string) => zeroBasedAddress(singleInFrame(text, table, context));
  const [from, to] = [at(first), at(last)];
  if (from === undefined || to === undefined || !Number.isInteger(from) || from < 0 || to < from || to > LAST_ADDRESS)
    return undefined;
  return { address: from, quantity: to - from + 1 };
}

/** The draft with an address as it was typed; a range fills the quantity too, or the list that has its length. */
export function withAddress(
  draft: Draft,
  { path, typed, table }: { readonly path: string; readonly typed: string; readonly table: Table },
  context: AddressContext,
  device?: string,
): Draft {
  const quantityPath = quantityOf(path);
  // What is one address of its own cannot be a range.
  if (quantityPath === undefined) return withTyped(draft, path, typed, singleInFrame(typed, table, context), device);
  const next = withTyped(draft, path, typed, addressInFrame(typed, table, context), device);
  const range = addressRange(typed, table, context);
  if (range === undefined) return next;
  const { controls } = evaluate(next);
  const quantity = controls.find((control) => control.path === quantityPath);
  if (quantity?.derived === false) return withText(next, quantityPath, String(range.quantity));
  const list = controls.find(({ field }) => field.kind === 'registers' || field.kind === 'bits');
  return list === undefined ? next : withText(next, list.path, ofLength(list.text, range.quantity));
}

/** A list with as many items: the last are left out, or zeros added. */
function ofLength(text: string, length: number): string {
  const items = text.split(/[\s,;]+/).filter((item) => item !== '');
  return Array.from({ length }, (_, index) => items[index] ?? '0').join(' ');
}

/** Whether an address is written with the six digits in which manuals print large ones: `401000`. */
export const saysSixDigits = (typed: string): boolean => /(?<!\w)[0134]\d{5}(?!\w)/.test(typed);

/** Whether an address of a draft was typed so, and is still what its field has. */
export const isSixDigits = (draft: Draft): boolean =>
  Object.entries(draft.texts).some(
    ([path, text]) => /address$/i.test(path) && saysSixDigits(typedAt(draft, path) ?? text),
  );

/** Whether what was typed as a range is still what the quantity says. */
export function isStillRange(
  draft: Draft,
  path: string,
  typed: string,
  table: Table,
  context: AddressContext,
): boolean {
  const range = addressRange(typed, table, context);
  const quantity = draft.texts[quantityOf(path) ?? ''];
  return range === undefined || quantity === undefined || readNumber(quantity) === range.quantity;
}

/** An address that may be two things, of which nobody has chosen one: a manual's number, or the address itself. */
export interface OpenReading {
  readonly path: string;
  readonly typed: string;
  readonly table: Table;
  /** The address, from 0, of each. */
  readonly number: number;
  readonly address: number;
  readonly taken: AddressReading;
}

/** The addresses of a draft that are open: what was typed, or in an older link stands, as a manual prints it. */
export function openReadings(draft: Draft, { description, controls }: Evaluation, context: AddressContext) {
  const { table } = description;
  if (table === undefined || table === 'file-record') return [];
  return controls.flatMap(({ path, field, text }: Control): OpenReading[] => {
    if (field.kind !== 'address') return [];
    const typed = (typedAt(draft, path) ?? text).trim();
    const printed = printedAs(typed, table, context);
    const got = zeroBasedAddress(text);
    const taken = got === printed?.number ? 'number' : got === printed?.address ? 'address' : undefined;
    if (printed === undefined || taken === undefined || (printed.decided && printed.which === taken)) return [];
    return [{ path, typed, table, number: printed.number, address: printed.address, taken }];
  });
}

/** The draft with an open address taken for one of its readings, in a way that nothing else is read from. */
export const settled = (draft: Draft, open: OpenReading, which: AddressReading): Draft =>
  withText(
    draft,
    open.path,
    which === 'number' ? clearAddress(open.table, open.number) : clearProtocolAddress(open.table, open.address),
  );

/** How many items a frame asks for from the address at `path` on; `undefined` if it does not say. */
export function addressQuantity({ frame }: Pick<Evaluation, 'frame'>, path: string): number | undefined {
  const name = quantityOf(path);
  const quantity = frame && name ? fieldValue(frame.reading, name) : undefined;
  return typeof quantity === 'number' ? quantity : undefined;
}

/** Four digits at most, in hexadecimal or without zeros in front: nobody takes these for a number as manuals print it. */
const PLAIN = /^(0x[\da-f]{1,4}|0|[1-9]\d{0,3})$/i;

/**
 * Whether a frame's address may be in a trap that needs a look. Most are not, and this tells it without what knows the
 * traps.
 */
export function mayBeTrapped(
  text: string,
  quantity: number | undefined,
  { convention }: Pick<AddressContext, 'convention'>,
): boolean {
  const typed = text.trim();
  return convention !== 'protocol' || !PLAIN.test(typed) || Number(typed) + (quantity ?? 1) - 1 > LAST_ADDRESS;
}
