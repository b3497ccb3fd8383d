import { wordsOf } from './codec.ts';
import { listName, plainName, plainNames, seriesStart } from './numbering.ts';
import { type EntityTable, entityTables, type Register } from './profile.ts';

type Lines = readonly Register[];

/** A line among those of its table, sorted by address: a balanced tree whose root is the middle one. */
interface Span {
  readonly register: Register;
  /** Its index in the profile. */
  readonly place: number;
  /** The first address behind it, where each value takes as many addresses as registers. */
  readonly end: number;
  /** The greatest end in the tree of which this is the root. */
  most: number;
}

const tables = new WeakMap<Lines, ReadonlyMap<EntityTable, readonly Span[]>>();

/**
 * The lines that may hold an address, in the order of the profile: those that do, and of a device that counts each value as
 * one address also those that would reach it with all their registers. Each list of lines is sorted once.
 */
export function linesNear(registers: Lines, table: EntityTable, address: number): readonly Register[] {
  const spans = (tables.get(registers) ?? sorted(registers)).get(table) ?? [];
  const found: Span[] = [];
  gather(spans, address, 0, spans.length, found);
  return found.sort((one, other) => one.place - other.place).map(({ register }) => register);
}

function sorted(registers: Lines): ReadonlyMap<EntityTable, readonly Span[]> {
  const spans = new Map<EntityTable, Span[]>(entityTables.map((table) => [table, []]));
  registers.forEach((register, place) => {
    const { table, address, count, type } = register;
    const end = address + count * wordsOf(type);
    spans.get(table)?.push({ register, place, end, most: end });
  });
  for (const each of spans.values()) {
    each.sort((one, other) => one.register.address - other.register.address);
    reach(each, 0, each.length);
  }
  tables.set(registers, spans);
  return spans;
}

function reach(spans: readonly Span[], from: number, to: number): number {
  if (from >= to) return 0;
  const middle = (from + to) >> 1;
  const root = spans[middle] as Span;
  root.most = Math.max(root.end, reach(spans, from, middle), reach(spans, middle + 1, to));
  return root.most;
}

function gather(spans: readonly Span[], address: number, from: number, to: number, found: Span[]): void {
  if (from >= to) return;
  const middle = (from + to) >> 1;
  const root = spans[middle] as Span;
  if (root.most <= address) return;
  gather(spans, address, from, middle, found);
  if (root.register.address > address) return;
  if (root.end > address) found.push(root);
  gather(spans, address, middle + 1, to, found);
}

interface Names {
  /** Places of lines by their names. */
  readonly lines: ReadonlyMap<string, readonly number[]>;
  /** Places of series by what stands in front of their numbers. */
  readonly series: ReadonlyMap<string, readonly number[]>;
  readonly longestStart: number;
}

const named = new WeakMap<Lines, Names>();

/** Where in a list of lines those stand that may have a value with this name, in order. Names are collected once for each list. */
export function placesNear(registers: Lines, text: string): readonly number[] {
  const { lines, series, longestStart } = named.get(registers) ?? collected(registers);
  const name = plainName(text);
  const starts = Array.from({ length: Math.min(longestStart, name.length) + 1 }, (_, end) => name.slice(0, end));
  const found = [
    ...[name, listName(name) ?? name].map((each) => lines.get(each) ?? []),
    ...starts.map((start) => series.get(start) ?? []),
  ].flat();
  return [...new Set(found)].sort((one, other) => one - other);
}

function collected(registers: Lines): Names {
  const [lines, series] = [new Map<string, number[]>(), new Map<string, number[]>()];
  let longestStart = -1;
  registers.forEach((register, place) => {
    for (const name of plainNames(register)) put(lines, name, place);
    const start = seriesStart(register);
    if (start === undefined) return;
    put(series, start, place);
    longestStart = Math.max(longestStart, start.length);
  });
  const names = { lines, series, longestStart };
  named.set(registers, names);
  return names;
}

function put(places: Map<string, number[]>, name: string, place: number): void {
  const there = places.get(name);
  if (there) there.push(place);
  else places.set(name, [place]);
}
