import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from 'vitest';

const src = resolve(import.meta.dirname, '../../../src');
const layers = [
  'modbus',
  'notation',
  'diagnosis',
  'trace',
  'captures',
  'devices',
  'sequences',
  'codegen',
  'workbench',
  'words',
  'store',
  'bus',
];

/**
 * What lasts from one call to the next below the page. A memo always has the same content, and each use of a scratch space
 * begins with emptying it; nothing else may stand here, because unit tests share their modules.
 */
const memos = [
  'modbus/crc-windows.ts',
  'modbus/crc.ts',
  'modbus/checksum-steps/crc-steps.ts',
  'devices/line-index.ts',
  'devices/line-scale.ts',
  'devices/search.ts',
  'workbench/frame/forced.ts',
];
const scratches = [
  'modbus/encode-frame.ts',
  'modbus/frames-at.ts',
  'modbus/rtu-end.ts',
  'diagnosis/hypotheses/checksum/text.ts',
];

/** A variable of a module, or something that can be changed: an object of a class, a list or a table without content. */
const state = /^(?:export )?(?:let |const \w+(?:: [^=]+)? = (?:new |\[\];|\{\};))/;
/** Constants: tables and lists with their content, formats, and nothing of length 0. */
const constant =
  /^(?:export )?const \w+(?:: [^=]+)? = new (?:RegExp|(?:Set|Map)(?:<[^(]+>)?\((?!\))|Intl\.|Uint8Array\(0?\))/;

test('the layers below the page keep nothing but memos and scratch spaces', () => {
  const found = layers.flatMap((layer) =>
    readdirSync(join(src, layer), { recursive: true, encoding: 'utf8' })
      .filter((file) => file.endsWith('.ts'))
      .map((file) => join(layer, file))
      .filter((file) =>
        readFileSync(join(src, file), 'utf8')
          .split('\n')
          .some((line) => state.test(line) && !constant.test(line)),
      ),
  );
  expect(found.sort()).toEqual([...memos, ...scratches].sort());
});
