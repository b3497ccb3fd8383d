import { isObject, isScalar, type Loose, numberOf, plainKey, textOf } from './loose.ts';
import { factsOf, orderText, tableNamed } from './object-facts.ts';
import { namesText } from './object-names.ts';
import type { Sheet, SheetProblem, SheetRow } from './sheet.ts';

const DEEPEST = 40;
const LONGEST_ADDRESS = 24;

/** Words under which a file says where a register is; the last part of a key, letters and digits only. */
const ADDRESS =
  /^(?:(?:start|base|reg|register|modbus|data|mem|memory)?(?:address|addr|adr|adresse)|regs?|registers?|registernumber|registerno|regno|startregister)$/;

const hasAddress = (value: Loose): boolean =>
  Object.entries(value).some(([key, each]) => {
    if (!ADDRESS.test(plainKey(key))) return false;
    return isObject(each)
      ? hasAddress(each)
      : Array.isArray(each)
        ? numberOf(each[0]) !== undefined
        : /\d/.test(textOf(each));
  });

/** An object that says something of what stands beside it. */
const isPlain = (value: Loose): boolean => Object.values(value).every(isScalar) && !hasAddress(value);

/** Registers that follow each other, such as `[9, 10]`, as a range. */
function rangeText(key: string, value: unknown): string | undefined {
  if (!Array.isArray(value) || value.length < 2 || !ADDRESS.test(plainKey(key))) return undefined;
  const numbers = value.map(numberOf);
  const [first] = numbers;
  if (first === undefined || !numbers.every((number, index) => number === first + index)) return undefined;
  return `${textOf(value[0])}-${textOf(value.at(-1))}`;
}

/** Finds every list of objects, and every map of objects that are alike, in a value of JSON, YAML or TOML. */
export function readObjects(value: unknown, problems: SheetProblem[], most: number): readonly Sheet[] {
  const sheets: Sheet[] = [];
  let cellsLeft = most;
  let items = 0;
  walk(value, '', 0, {}, {});
  if (cellsLeft < 0) problems.push({ code: 'too-many-cells', most });
  return sheets;

  function walk(each: unknown, name: string, depth: number, facts: Sheet['facts'], above: Loose): void {
    if (isScalar(each) || depth > DEEPEST || cellsLeft < 0) return;
    if (Array.isArray(each)) {
      const objects = each.filter(isObject);
      if (objects.length > 0) list(objects, name, depth, facts, above);
      else if (each.some((row) => Array.isArray(row) && row.length > 1 && row.every(isScalar))) {
        emit(
          name,
          each.map((row) => (Array.isArray(row) ? row.map(textOf) : [textOf(row)])),
          facts,
          false,
        );
      } else for (const inner of each) walk(inner, name, depth + 1, facts, above);
      return;
    }
    if (!isObject(each)) return;
    const keyed = keyedList(each);
    if (keyed) {
      list(keyed, name, depth, facts, above);
      return;
    }
    const pairs = addressPairs(each, name);
    if (pairs) {
      emit(name, pairs, facts, true);
      return;
    }
    const said = { ...facts };
    for (const inner of Object.values(each)) if (isObject(inner) && isPlain(inner)) Object.assign(said, factsOf(inner));
    Object.assign(said, factsOf(each));
    for (const [key, inner] of Object.entries(each)) {
      const table = tableNamed(key);
      walk(inner, key, depth + 1, table ? { ...said, table } : said, above);
    }
  }

  /** Items that hold lists of registers stand for them, and give them what they say; all others are rows. */
  function list(objects: readonly Loose[], name: string, depth: number, facts: Sheet['facts'], above: Loose): void {
    const rows: Loose[] = [];
    for (const item of objects) {
      const inner = Object.entries(item).filter(([, each]) => holdsRegisters(each, depth));
      if (inner.length === 0) {
        rows.push({ ...above, ...item });
        continue;
      }
      const own = Object.fromEntries(
        Object.entries(item).flatMap(([key, each]) => (isScalar(each) ? [[`${name}.${key}`, each]] : [])),
      );
      const told = factsOf(item);
      const said = { ...facts, ...(OF_DEVICES.test(plainKey(name)) ? told : withoutDevice(told)) };
      for (const [key, each] of inner) {
        const table = tableNamed(key);
        walk(each, key, depth + 1, table ? { ...said, table } : said, { ...above, ...own });
      }
    }
    if (rows.length > 0) table(rows, name, depth, facts);
  }

  function table(objects: readonly Loose[], name: string, depth: number, facts: Sheet['facts']): void {
    const columns = new Map<string, number>();
    const flat = objects.map((item) => {
      const cells = new Map<string, string>();
      flatten(item, '', cells, depth);
      for (const key of cells.keys()) if (!columns.has(key)) columns.set(key, columns.size);
      return cells;
    });
    cellsLeft -= columns.size * objects.length;
    if (cellsLeft < 0) return;
    const header = [...columns.keys()];
    emit(name, [header, ...flat.map((cells) => header.map((key) => cells.get(key) ?? ''))], facts, true);
  }

  function flatten(item: Loose, prefix: string, cells: Map<string, string>, depth: number): void {
    for (const [key, each] of Object.entries(item)) {
      if (cellsLeft-- < 0) return;
      const path = prefix + key;
      const names = isScalar(each) ? undefined : namesText(each);
      if (names !== undefined) cells.set(path, names);
      else if (isObject(each)) {
        if (depth < DEEPEST) flatten(each, `${path}.`, cells, depth + 1);
      } else if (Array.isArray(each) && !each.every(isScalar)) {
        if (depth < DEEPEST)
          flatten(Object.fromEntries(each.map((inner, index) => [String(index), inner])), `${path}.`, cells, depth + 1);
      } else cells.set(path, rangeText(key, each) ?? orderText(plainKey(key), textOf(each)));
    }
  }

  function emit(name: string, rows: readonly (readonly string[])[], facts: Sheet['facts'], headed: boolean): void {
    const own: Sheet = {
      ...(name === '' ? {} : { name }),
      kind: 'objects',
      rows: rows.map((cells, index): SheetRow => ({ line: headed && index === 0 ? 0 : ++items, cells })),
      ...(headed ? { headed } : {}),
      ...(facts && Object.keys(facts).length > 0 ? { facts } : {}),
    };
    sheets.push(own);
  }
}

/** Lists whose items are devices, so that their names are those of devices. */
const OF_DEVICES = /device|profile|slave|meter|product|inverter|hub|plc|unit|model/;

const withoutDevice = (facts: Sheet['facts']): Sheet['facts'] => {
  const { device: _device, source: _source, ...rest } = facts ?? {};
  return rest;
};

/** Whether there is a list of objects with addresses somewhere in a value. */
function holdsRegisters(value: unknown, depth: number): boolean {
  if (isScalar(value) || depth > DEEPEST) return false;
  const inner = Array.isArray(value) ? value : Object.values(value as Loose);
  if (Array.isArray(value) && value.some((each) => isObject(each) && hasAddress(each))) return true;
  return inner.some((each) => holdsRegisters(each, depth + 1));
}

/** The objects of a map such as `{ "40001": { … }, "40002": { … } }`, each with its key as address or name. */
function keyedList(value: Loose): readonly Loose[] | undefined {
  const entries = Object.entries(value);
  const objects = entries.filter((entry): entry is [string, Loose] => isObject(entry[1]));
  if (objects.length === 0 || entries.some(([, each]) => Array.isArray(each) && !each.every(isScalar)))
    return undefined;
  if (objects.some(([, each]) => holdsRegisters(each, 0))) return undefined;
  const whole = objects.length > 1 && objects.length === entries.length;
  const byAddress =
    objects.every(
      ([key]) => key.length <= LONGEST_ADDRESS && /^(?:0x[\da-f]+|[\da-f]*\d[\da-f]*h?)(?:[-.:/]\d+)*$/i.test(key),
    ) && !objects.some(([, each]) => hasAddress(each));
  if (
    !byAddress &&
    !objects.every(([, each]) => hasAddress(each)) &&
    !(whole && alike(objects.map(([, each]) => each)))
  )
    return undefined;
  const key = byAddress ? 'address' : objects.some(([, each]) => Object.hasOwn(each, 'name')) ? 'key' : 'name';
  return objects.map(([own, each]) => ({ [key]: own, ...each }));
}

/** The rows of a map of addresses and names, either of them first; names first only under a key that speaks of registers. */
function addressPairs(value: Loose, name: string): readonly (readonly string[])[] | undefined {
  const entries = Object.entries(value);
  if (entries.length < 2 || !entries.every(([, each]) => isScalar(each))) return undefined;
  const isAddress = (text: string) => /^(?:0x[\da-f]{1,6}|\d{1,6})$/i.test(text);
  if (entries.every(([key, each]) => isAddress(key) && typeof each === 'string'))
    return [['address', 'name'], ...entries.map(([key, each]) => [key, textOf(each)])];
  const speaks = tableNamed(name) !== undefined || /regist|address|tags|points/i.test(name);
  if (!speaks || !entries.every(([key, each]) => !isAddress(key) && isAddress(textOf(each)))) return undefined;
  return [['name', 'address'], ...entries.map(([key, each]) => [key, textOf(each)])];
}

/** Whether objects have mostly the same keys, with scalars under most of them. */
function alike(objects: readonly Loose[]): boolean {
  const counts = new Map<string, number>();
  let scalars = 0;
  let all = 0;
  for (const each of objects) {
    for (const [key, inner] of Object.entries(each)) {
      counts.set(key, (counts.get(key) ?? 0) + 1);
      all++;
      if (isScalar(inner)) scalars++;
    }
  }
  const shared = [...counts.values()].some((count) => count === objects.length);
  return shared && scalars * 2 > all;
}
