import { beforeAll, describe, expect, test } from 'vitest';
import { type Check, type Verdict, verdictOn } from './sandbox.ts';

/**
 * A check that cannot fail is worse than none, so each rule of the layers is broken once, on purpose. All that one check
 * must refuse is planted at once, each in files of its own, because a run costs seconds.
 */
interface Violation {
  readonly what: string;
  readonly files: Readonly<Record<string, string>>;
  /** The check that must refuse it, the file it must name, and the rule it must give. */
  readonly check: Check;
  readonly at: string;
  readonly rule: string;
}

const upward = (from: string, to: string): Violation => ({
  what: `${from} imports ${to}`,
  files: {
    [`${from}/planted-below-${to}.ts`]: `export { planted } from '../${to}/planted-above-${from}.ts';\n`,
    [`${to}/planted-above-${from}.ts`]: 'export const planted = 1;\n',
  },
  check: 'types',
  at: `src/${from}/planted-below-${to}.ts`,
  rule: 'TS6307',
});

const pure = (layer: string, what: string, text: string, check: Check, rule: string): Violation => {
  const file = `${layer}/planted-${what.toLowerCase().replaceAll(' ', '-')}.ts`;
  return { what: `${what} in ${layer}`, files: { [file]: text }, check, at: `src/${file}`, rule };
};

const restrictedGlobal = 'lint/style/noRestrictedGlobals';
const restrictedImport = 'lint/style/noRestrictedImports';

const room = (what: string, file: string, text: string, rule: string): Violation => ({
  what,
  files: { [`ui/${file}`]: text },
  check: 'rooms',
  at: `src/ui/${file}`,
  rule,
});

const violations: readonly Violation[] = [
  upward('modbus', 'notation'),
  upward('modbus', 'words'),
  upward('modbus', 'diagnosis'),
  upward('diagnosis', 'notation'),
  upward('diagnosis', 'words'),
  upward('modbus', 'devices'),
  upward('notation', 'devices'),
  upward('diagnosis', 'devices'),
  upward('devices', 'words'),
  upward('modbus', 'bus'),
  upward('notation', 'bus'),
  upward('diagnosis', 'bus'),
  upward('devices', 'bus'),
  upward('bus', 'words'),
  upward('bus', 'ui'),
  upward('modbus', 'sequences'),
  upward('notation', 'sequences'),
  upward('diagnosis', 'sequences'),
  upward('devices', 'sequences'),
  upward('diagnosis', 'trace'),
  upward('trace', 'captures'),
  upward('trace', 'devices'),
  upward('captures', 'devices'),
  upward('captures', 'bus'),
  upward('sequences', 'bus'),
  upward('sequences', 'codegen'),
  upward('codegen', 'bus'),
  upward('codegen', 'workbench'),
  upward('codegen', 'words'),
  upward('modbus', 'workbench'),
  upward('devices', 'workbench'),
  upward('sequences', 'workbench'),
  upward('bus', 'workbench'),
  upward('workbench', 'words'),
  upward('workbench', 'ui'),
  upward('notation', 'words'),
  upward('notation', 'ui'),
  upward('words', 'ui'),
  upward('workbench', 'store'),
  upward('words', 'store'),
  upward('bus', 'store'),
  upward('store', 'ui'),
  pure('modbus', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('trace', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('captures', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('sequences', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('codegen', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('workbench', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('store', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('words', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('diagnosis', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('devices', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('notation', 'Node', "export { readFileSync } from 'node:fs';\n", 'types', 'TS2591'),
  pure('modbus', 'Date', 'export const now = Date.now();\n', 'lint', restrictedGlobal),
  pure('words', 'Date', 'export const now = new Date();\n', 'lint', restrictedGlobal),
  pure('modbus', 'Date by way of globalThis', 'export const now = globalThis.Date.now();\n', 'lint', restrictedGlobal),
  pure('modbus', 'performance', 'export const now = performance.now();\n', 'lint', restrictedGlobal),
  pure('workbench', 'Date', 'export const now = Date.now();\n', 'lint', restrictedGlobal),
  pure('sequences', 'setTimeout', 'setTimeout(() => undefined, 1);\n', 'lint', restrictedGlobal),
  pure('notation', 'fetch', "export const page = fetch('./');\n", 'lint', restrictedGlobal),
  pure('modbus', 'setTimeout', 'setTimeout(() => undefined, 1);\n', 'lint', restrictedGlobal),
  pure('codegen', 'Date', 'export const now = Date.now();\n', 'lint', restrictedGlobal),
  pure('codegen', 'a package', "export { zipSync } from 'fflate';\n", 'lint', restrictedImport),
  pure('devices', 'a package', "export { zipSync } from 'fflate';\n", 'lint', restrictedImport),
  pure('notation', 'a package', "export { signal } from '@preact/signals';\n", 'lint', restrictedImport),
  pure('workbench', 'a package', "export { signal } from '@preact/signals-core';\n", 'lint', restrictedImport),
  pure('store', 'a package', "export { signal } from '@preact/signals';\n", 'lint', restrictedImport),
  pure('store', 'setTimeout', 'setTimeout(() => undefined, 1);\n', 'lint', restrictedGlobal),
  pure('store', 'Date', 'export const now = Date.now();\n', 'lint', restrictedGlobal),
  pure('bus', 'a package', "export { zipSync } from 'fflate';\n", 'lint', restrictedImport),
  pure('modbus', 'lib reference', '/// <reference lib="dom" />\nexport {};\n', 'references', 'noTripleSlashReference'),
  pure(
    'words',
    'types reference',
    '/// <reference types="node" />\nexport {};\n',
    'references',
    'noTripleSlashReference',
  ),
  ...(
    ['notation', 'diagnosis', 'devices', 'sequences', 'codegen', 'bus', 'workbench', 'words', 'store', 'ui'] as const
  ).map((layer) => ({
    what: `${layer} imports past an index.ts`,
    files: {
      [`${layer}/planted-past.ts`]: `export { planted } from '../modbus/planted-inside-${layer}.ts';\n`,
      [`modbus/planted-inside-${layer}.ts`]: 'export const planted = 1;\n',
    },
    check: 'lint' as const,
    at: `src/${layer}/planted-past.ts`,
    rule: restrictedImport,
  })),
  {
    what: 'ui imports a type past an index.ts, in place',
    files: {
      'ui/planted-in-place.ts': "export type Planted = import('../modbus/planted-type.ts').Planted;\n",
      'modbus/planted-type.ts': 'export type Planted = 1;\n',
    },
    check: 'lint',
    at: 'src/ui/planted-in-place.ts',
    rule: 'plugin',
  },
  {
    what: 'ui writes hexadecimal by its own code',
    files: { 'ui/planted.ts': 'export const planted = (value: number) => value.toString(16);\n' },
    check: 'lint',
    at: 'src/ui/planted.ts',
    rule: 'plugin',
  },
  ...[
    [
      'a table by name',
      'const table: Readonly<Record<string, number>> = { a: 1 };\nexport const planted = (name: string) => table[name];\n',
    ],
    [
      'a table by name that only some names have',
      'export const planted: Readonly<Partial<Record<string, number>>> = { a: 1 };\n',
    ],
    [
      'a table by name of a class',
      'export class Planted {\n  readonly table: Readonly<Record<string, number>> = { a: 1 };\n}\n',
    ],
    [
      'an empty object for a missing table',
      'export const planted = (name: string, table: Readonly<Record<string, number>> = {}) => table[name];\n',
    ],
    [
      'a text that is said to be a name',
      'const table = { a: 1 };\nexport const planted = (name: string) => table[name as keyof typeof table];\n',
    ],
    ['a name asked for with in', 'const table = { a: 1 };\nexport const planted = (name: string) => name in table;\n'],
  ].map(([what = '', text = ''], index) => ({
    what,
    files: { [`devices/planted-map-${index}.ts`]: text },
    check: 'lint' as const,
    at: `src/devices/planted-map-${index}.ts`,
    rule: 'plugin',
  })),
  {
    what: 'two files import each other',
    files: {
      'modbus/planted-one.ts': "import { two } from './planted-two.ts';\n\nexport const one: number = two;\n",
      'modbus/planted-two.ts': "import { one } from './planted-one.ts';\n\nexport const two: number = one;\n",
    },
    check: 'lint',
    at: 'src/modbus/planted-one.ts',
    rule: 'lint/suspicious/noImportCycles',
  },
  room('a view imports another', 'bus/planted-view.ts', "export { Form } from '../frame/form.tsx';\n", 'arrowBack'),
  room(
    'a view loads another',
    'timing/planted-later.ts',
    "export const planted = () => import(\n  '../bus/scan/planted-panel.tsx'\n);\n",
    'arrowBack',
  ),
  room('a view takes the style of another', 'reference/planted.css', "@import '../timing/timing.css';\n", 'arrowBack'),
  room('parts import a view', 'parts/planted-up.ts', "import '../timing/timing.css';\n", 'arrowBack'),
  room(
    'the kit imports the store',
    'kit/planted-store.ts',
    "export { draft } from '../../store/index.ts';\n",
    'kitImports',
  ),
  room(
    'the kit imports a type of Modbus',
    'kit/planted-type.ts',
    "import type { Reading } from '../../modbus/index.ts';\n\nexport type Planted = Reading;\n",
    'kitImports',
  ),
  room('the kit imports parts', 'kit/planted-parts.ts', "export { useWords } from '../parts/words.ts';\n", 'arrowBack'),
  room(
    'a view imports words by value',
    'timing/planted-words.ts',
    "import { type Language, languages } from '../../words/index.ts';\n\nexport const planted: Language = languages.en;\n",
    'wordsByValue',
  ),
  room(
    'a panel of a view exports words',
    'bus/scan/planted-words.ts',
    "export * from '../../../words/index.ts';\n",
    'wordsByValue',
  ),
  room(
    'a part loads words',
    'parts/planted-words.ts',
    "export const planted = () => import('../../words/en/bus.ts');\n",
    'wordsByValue',
  ),
  room('a room without a floor', 'planted-room.ts', 'export const planted = 1;\n', 'noFloor'),
  {
    what: 'two files of one name',
    files: {
      'ui/frame/planted-form.tsx': 'export const planted = 1;\n',
      'ui/timing/planted-form.tsx': 'export const planted = 1;\n',
    },
    check: 'rooms',
    at: 'src/ui/timing/planted-form.tsx',
    rule: 'sameName',
  },
  {
    what: 'two files of one name in a layer',
    files: {
      'modbus/planted-hex.ts': 'export const planted = 1;\n',
      'modbus/fields/planted-hex.ts': 'export const planted = 1;\n',
    },
    check: 'rooms',
    at: 'src/modbus/fields/planted-hex.ts',
    rule: 'sameName',
  },
];

const checks: readonly Check[] = ['types', 'lint', 'references', 'rooms'];

/** What the pure layers may not use, ui may. */
const clocks = 'export const now = [Date.now(), performance.now()];\nsetTimeout(() => undefined, 1);\n';
const allowed = {
  'words/index.ts': "export type Language = 'en';\nexport type Subject = 'frame';\n",
  'bus/planted-clocks.ts': clocks,
  'ui/kit/planted-clocks.ts': clocks,
  'ui/timing/planted-types.ts':
    "export type { Language } from '../../words/index.ts';\nimport type { Subject } from '../../words/index.ts';\n\nexport type Planted = Subject;\n",
};

/** A line in which a check names a file with a fault. */
const NAMES_FILE = /^(?:\w+: )?src\/[^\s(:]+\.\w+[(:]/;

describe.each(checks)('%s', (check) => {
  const refused = violations.filter((violation) => violation.check === check);
  const planted = Object.assign({}, ...refused.map(({ files }) => files));
  let verdict: Verdict;

  beforeAll(async () => {
    verdict = await verdictOn({ ...planted, ...allowed }, check);
  });

  test('nothing else, and what bus and ui may use passes', () => {
    expect(verdict.passed).toBe(false);
    const faults = verdict.output.split('\n').filter((line) => NAMES_FILE.test(line));
    expect(faults.length).toBeGreaterThanOrEqual(refused.length);
    expect(faults.filter((line) => !Object.keys(planted).some((file) => line.includes(file)))).toEqual([]);
  });

  test.each(refused)('refused: $what', ({ at, rule }) => {
    expect(verdict.output.split('\n')).toContainEqual(expect.stringMatching(`${at}.*${rule}|${rule}.*${at}`));
  });
});
