import { afterAll, beforeAll, expect, test } from 'vitest';
import { type Check, makeSandbox, type Sandbox } from './sandbox.ts';

/** A check that cannot fail is worse than none, so each rule of the layers is broken once, on purpose. */
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
    [`${from}/planted.ts`]: `export { planted } from '../${to}/planted-above.ts';\n`,
    [`${to}/planted-above.ts`]: 'export const planted = 1;\n',
  },
  check: 'types',
  at: `src/${from}/planted.ts`,
  rule: 'TS6307',
});

const pure = (layer: string, what: string, text: string, check: Check, rule: string): Violation => ({
  what: `${what} in ${layer}`,
  files: { [`${layer}/planted.ts`]: text },
  check,
  at: `src/${layer}/planted.ts`,
  rule,
});

const restrictedGlobal = 'lint/style/noRestrictedGlobals';
const restrictedImport = 'lint/style/noRestrictedImports';

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
  upward('notation', 'words'),
  upward('notation', 'ui'),
  upward('words', 'ui'),
  pure('modbus', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('words', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('diagnosis', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('devices', 'the DOM', 'export const title = document.title;\n', 'types', 'TS2584'),
  pure('notation', 'Node', "export { readFileSync } from 'node:fs';\n", 'types', 'TS2591'),
  pure('modbus', 'Date', 'export const now = Date.now();\n', 'lint', restrictedGlobal),
  pure('words', 'Date', 'export const now = new Date();\n', 'lint', restrictedGlobal),
  pure('modbus', 'Date by way of globalThis', 'export const now = globalThis.Date.now();\n', 'lint', restrictedGlobal),
  pure('modbus', 'performance', 'export const now = performance.now();\n', 'lint', restrictedGlobal),
  pure('notation', 'fetch', "export const page = fetch('./');\n", 'lint', restrictedGlobal),
  pure('modbus', 'setTimeout', 'setTimeout(() => undefined, 1);\n', 'lint', restrictedGlobal),
  pure('devices', 'a package', "export { parse } from 'papaparse';\n", 'lint', restrictedImport),
  pure('notation', 'a package', "export { signal } from '@preact/signals';\n", 'lint', restrictedImport),
  pure('modbus', 'lib reference', '/// <reference lib="dom" />\nexport {};\n', 'references', 'noTripleSlashReference'),
  pure(
    'words',
    'types reference',
    '/// <reference types="node" />\nexport {};\n',
    'references',
    'noTripleSlashReference',
  ),
  ...(['notation', 'diagnosis', 'devices', 'words', 'ui'] as const).map((layer) => ({
    what: `${layer} imports past an index.ts`,
    files: {
      [`${layer}/planted.ts`]: "export { planted } from '../modbus/planted-inside.ts';\n",
      'modbus/planted-inside.ts': 'export const planted = 1;\n',
    },
    check: 'lint' as const,
    at: `src/${layer}/planted.ts`,
    rule: restrictedImport,
  })),
  {
    what: 'ui imports a type past an index.ts, in place',
    files: {
      'ui/planted.ts': "export type Planted = import('../modbus/planted-inside.ts').Planted;\n",
      'modbus/planted-inside.ts': 'export type Planted = 1;\n',
    },
    check: 'lint',
    at: 'src/ui/planted.ts',
    rule: 'plugin',
  },
  {
    what: 'two files import each other',
    files: {
      'modbus/planted.ts': "import { two } from './planted-too.ts';\n\nexport const one: number = two;\n",
      'modbus/planted-too.ts': "import { one } from './planted.ts';\n\nexport const two: number = one;\n",
    },
    check: 'lint',
    at: 'src/modbus/planted.ts',
    rule: 'lint/suspicious/noImportCycles',
  },
];

let sandbox: Sandbox;

beforeAll(async () => {
  sandbox = await makeSandbox();
});

afterAll(() => sandbox.remove());

test.each<Check>(['types', 'lint', 'references'])(
  '%s: the sources as they are pass',
  { timeout: 30_000 },
  async (check) => {
    expect(await sandbox.planted({}, check)).toMatchObject({ passed: true });
  },
);

test('what the pure layers may not use, ui may', { timeout: 30_000 }, async () => {
  const text = 'export const now = [Date.now(), performance.now()];\nsetTimeout(() => undefined, 1);\n';
  expect(await sandbox.planted({ 'ui/planted.ts': text }, 'lint')).toMatchObject({ passed: true });
});

test.each(violations)('refused: $what', { timeout: 30_000 }, async ({ files, check, at, rule }) => {
  const { passed, output } = await sandbox.planted(files, check);
  expect(passed).toBe(false);
  expect(output.split('\n')).toContainEqual(expect.stringMatching(`${at}.*${rule}|${rule}.*${at}`));
});
