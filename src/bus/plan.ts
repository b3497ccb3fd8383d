import { type EntityTable, isBitTable } from '../devices/index.ts';
import { decodeFrame, encodeFrame, LAST_ADDRESS, mostOf, readerOf, type SerialMode } from '../modbus/index.ts';

/** A value that is to be read. It is never split over two requests, so that all of it is of one moment. */
export interface Wanted {
  readonly unit: number;
  readonly table: EntityTable;
  /** As sent, counted from 0. */
  readonly address: number;
  /** How many addresses it takes. */
  readonly size: number;
  /** Registers in a reply for each address: more than 1 if the device counts a value as one address. */
  readonly width?: number;
}

/** One request of a plan. */
export interface PlannedRead extends Omit<Wanted, 'size'> {
  readonly width: number;
  readonly quantity: number;
}

/** Where a wanted value is: the index of the read, the first item in its reply, and the number of items. */
export interface Place {
  readonly read: number;
  readonly at: number;
  readonly size: number;
}

export interface Plan {
  readonly reads: readonly PlannedRead[];
  /** Of the wanted values, in their order; `undefined` for one that no request can read whole. */
  readonly places: readonly (Place | undefined)[];
}

/** Limits of the requests. */
export interface PlanRules {
  /** Most registers and bits in a request; the limits of the specification (AP 6.1, 6.3) hold in any case. */
  readonly registers?: number;
  readonly bits?: number;
  /** The most addresses between two wanted ones that are read as well, to save a request. */
  readonly gap?: number;
}

/** Eight registers take 16 characters on the line; one request more with its reply's frame and the silences about 20. */
export const DEFAULT_GAP = 8;

interface Run {
  readonly from: number;
  to: number;
  readonly members: number[];
}

/**
 * Reads that together have every wanted value whole, and each of its addresses once. Only values that overlap in a chain
 * longer than a request may be are read in requests that overlap.
 */
export function planReads(wanted: readonly Wanted[], rules: PlanRules = {}): Plan {
  const { gap = DEFAULT_GAP } = rules;
  const reads: PlannedRead[] = [];
  const places = new Array<Place | undefined>(wanted.length).fill(undefined);
  for (const group of groupsOf(wanted)) {
    const [{ unit, table, width = 1 }] = group.values;
    const most = mostAddresses(table, width, rules);
    const fitting = group.members.filter((index) => fits(wanted[index], most));
    const overlapping = joined(fitting.map((index) => runOf(wanted, index)).toSorted(byPlace), most, -1);
    for (const { from, to, members } of joined(overlapping, most, Math.max(0, gap))) {
      for (const index of members) {
        const { address, size } = wanted[index] as Wanted;
        places[index] = { read: reads.length, at: (address - from) * width, size: size * width };
      }
      reads.push({ unit, table, width, address: from, quantity: to - from });
    }
  }
  return { reads, places };
}

/** Wanted values that the same requests may read: of one unit, table and width, which begin in the order of their first. */
function groupsOf(wanted: readonly Wanted[]) {
  const groups = new Map<string, { readonly values: [Wanted, ...Wanted[]]; readonly members: number[] }>();
  for (const [index, value] of wanted.entries()) {
    const key = `${value.unit} ${value.table} ${value.width ?? 1}`;
    const group = groups.get(key);
    if (group === undefined) groups.set(key, { values: [value], members: [index] });
    else group.members.push(index);
  }
  return groups.values();
}

function mostAddresses(table: EntityTable, width: number, { registers, bits }: PlanRules): number {
  const legal = mostOf(readerOf(table));
  return Math.floor(Math.min(legal, (isBitTable(table) ? bits : registers) ?? legal) / width);
}

const fits = (value: Wanted | undefined, most: number) =>
  value !== undefined && value.size >= 1 && value.size <= most && value.address + value.size <= LAST_ADDRESS + 1;

function runOf(wanted: readonly Wanted[], index: number): Run {
  const { address, size } = wanted[index] as Wanted;
  return { from: address, to: address + size, members: [index] };
}

const byPlace = (a: Run, b: Run) => a.from - b.from || a.to - b.to;

/** Joins runs in ascending order that are at most `gap` apart (−1: that overlap) and no longer than `most` together. */
function joined(runs: readonly Run[], most: number, gap: number): Run[] {
  const all: Run[] = [];
  for (const { from, to, members } of runs) {
    const last = all.at(-1);
    if (last !== undefined && from - last.to <= gap && Math.max(last.to, to) - last.from <= most) {
      last.to = Math.max(last.to, to);
      last.members.push(...members);
    } else all.push({ from, to, members: [...members] });
  }
  return all;
}

/** The request of a planned read. */
export const requestFor = ({ unit, table, address, quantity }: PlannedRead, transport: SerialMode): Uint8Array =>
  encodeFrame({
    transport,
    direction: 'request',
    unitId: unit,
    functionCode: readerOf(table).code,
    fields: { startAddress: address, quantity },
  });

/**
 * The registers (0…65535) or bits (0, 1) that a reply has for a request. `undefined` for a reply that does not answer it, that
 * breaks a rule, and for an exception.
 */
export function itemsOf(
  { quantity, width }: Pick<PlannedRead, 'quantity' | 'width'>,
  request: Uint8Array,
  reply: Uint8Array,
  transport: SerialMode,
): readonly number[] | undefined {
  const { outcome, problems, fields } = decodeFrame(reply, { transport, direction: 'response', request });
  const list = Object.values(fields).find((field) => Array.isArray(field)) as readonly number[] | undefined;
  if (outcome.kind !== 'whole' || list === undefined || list.length < quantity * width) return undefined;
  const wrong = problems.filter(({ severity }) => severity === 'error');
  // Where each address is a value of several registers, the count cannot be what the specification asks for.
  const isWider = width > 1 && wrong.every(({ code }) => code === 'count-not-as-requested');
  return wrong.length === 0 || isWider ? list : undefined;
}
