import { isObject, type Loose, textOf, valueAt } from '../loose.ts';
import { usualLimits } from '../sheet.ts';
import { readYaml } from '../yaml.ts';
import { type NamedFormat, type NamedRow, readHolding, readInput } from './named-format.ts';

const DEEPEST = 20;
/** The type is that of a read, or says how it is written. */
const TABLES: readonly (readonly [RegExp, string])[] = [
  [/^(?:write)?coils?$|^writesinglecoil$/, 'coil'],
  [/^discrete/, 'discrete-input'],
  [/^input/, readInput],
  [/./, readHolding],
];

/**
 * Plug-ins `source: modbus` of evcc, in a configuration or a template: https://docs.evcc.io/docs/devices/plugins. What a template
 * renders is read for each use (grid, pv, battery) alone; the comment behind an address describes it.
 */
export const evcc: NamedFormat = {
  format: 'evcc',
  read: (value) => {
    const render = valueAt(value, 'render');
    const rendered = typeof render === 'string' ? templateRows(render) : rowsIn(value, '', '', 0);
    const rows = [...rendered, ...serviceRows(valueAt(value, 'params'))];
    if (rows.length === 0) return undefined;
    const device = textOf(valueAt(value, 'template'));
    return [{ facts: { counting: 'zero', ...(device === '' ? {} : { device }) }, rows }];
  },
};

/** The rows of what a template of Go renders. Lines of the template are left out, its values become a word. */
function templateRows(render: string): NamedRow[] {
  const sections = new Map<string, string[]>();
  const open: string[] = [];
  for (const line of render.split(/\r?\n/)) {
    const [whole, word] = /^\s*\{\{-?\s*(?:(if|else|end|range|with)\b)?.*\}\}\s*$/.exec(line) ?? [];
    if (whole !== undefined) {
      if (word === 'end' || word === 'else') open.pop();
      if (word !== undefined && word !== 'end') open.push(/eq\s+\.usage\s+"(\w+)"/.exec(line)?.[1] ?? '');
      continue;
    }
    const section = open.findLast((each) => each !== '') ?? '';
    const lines = sections.get(section) ?? [];
    sections.set(section, lines);
    lines.push(...described(line.replace(/\{\{[^{}]*\}\}/g, 'x')));
  }
  return [...sections].flatMap(([use, lines]) =>
    readYaml(lines.join('\n'), [], usualLimits.nodes).flatMap((value) => rowsIn(value, '', use, 0)),
  );
}

/** A line with an address and a comment, and the comment as a key of its own. */
function described(line: string): string[] {
  const [, before = '', key = '', comment = ''] = /^([\s-]*)(address:\s*[^#\s]+)\s+#\s*(.+)$/.exec(line) ?? [];
  return comment === '' ? [line] : [before + key, `${before.replaceAll('-', ' ')}comment: ${JSON.stringify(comment)}`];
}

function rowsIn(value: unknown, path: string, group: string, depth: number): NamedRow[] {
  if (depth > DEEPEST) return [];
  if (Array.isArray(value))
    return value.flatMap((each, index) =>
      rowsIn(each, `${path} ${textOf(valueAt(each, 'name')) || index + 1}`.trim(), group, depth + 1),
    );
  if (!isObject(value)) return [];
  const own =
    value['source'] === 'modbus' && isObject(value['register']) ? [rowOf(value, value['register'], path, group)] : [];
  const inner = Object.entries(value).flatMap(([key, each]) => {
    const transparent = /^(?:get|set|source|add|sub|mul|div|in|out|script)$/.test(key);
    return rowsIn(each, transparent ? path : `${path} ${key}`.trim(), group, depth + 1);
  });
  return [...own, ...inner];
}

function rowOf(plugin: Loose, register: Loose, path: string, group: string): NamedRow {
  return {
    ...registerOf(textOf(register['type']), textOf(register['decode'] ?? register['encoding'])),
    name: path,
    address: textOf(register['address']),
    registers: textOf(register['length']),
    mask: textOf(register['bitmask'] ?? register['mask']),
    factor: textOf(plugin['scale']),
    group,
    description: textOf(register['comment']),
  };
}

function registerOf(type: string, decode: string): NamedRow {
  const kind = type.toLowerCase();
  const table = TABLES.find(([pattern]) => pattern.test(kind || 'holding'))?.[1];
  const [, said = decode, first, nan, second] = /^(ieee754|(?:u?int|float|bool)\d+)(s)?(nan)?(s)?$/i.exec(decode) ?? [];
  const name = said
    .toLowerCase()
    .replace('ieee754', 'float32')
    .replace(/^bool\d+$/, 'bool');
  return {
    table,
    type: table === 'coil' || table === 'discrete-input' ? 'bool' : name,
    order: first || second ? 'CDAB' : /\d{2}$/.test(name) && !/16$/.test(name) ? 'ABCD' : '',
    access: kind.startsWith('write') ? 'w' : '',
    notImplemented: nan ? notImplemented(name) : '',
  };
}

/** What `nan` behind a type stands for: all bits of it, or the sign alone. */
const notImplemented = (type: string): string => {
  const digits = Number(/\d+$/.exec(type)?.[0] ?? 0) / 4;
  return type.startsWith('uint')
    ? `0x${'F'.repeat(digits)}`
    : type.startsWith('int')
      ? `0x8${'0'.repeat(digits - 1)}`
      : 'NaN';
};

/** Parameters that a template reads from the device: `modbus/read?address=…&type=…&encoding=…`. */
function serviceRows(params: unknown): NamedRow[] {
  if (!Array.isArray(params)) return [];
  return params.filter(isObject).flatMap((param): NamedRow[] => {
    const [, query = ''] = /^modbus\/read\?(.*)$/.exec(textOf(param['service'])) ?? [];
    if (query === '') return [];
    const said = new Map(
      query.split('&').map((each) => [each.slice(0, each.indexOf('=')), each.slice(each.indexOf('=') + 1)] as const),
    );
    return [
      {
        ...registerOf(said.get('type') ?? '', said.get('encoding') ?? ''),
        name: textOf(param['name']),
        address: said.get('address'),
        factor: said.get('scale'),
        group: 'params',
      },
    ];
  });
}
