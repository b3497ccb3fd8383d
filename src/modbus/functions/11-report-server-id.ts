import { layout } from '../field.ts';
import { hex } from '../fields/hex.ts';
import { count, stated } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

export const reportServerId = defineFunction({
  code: 0x11,
  name: 'Report Server ID',
  section: 'AP 6.13',
  group: 'identification',
  serialOnly: true,
  request: layout([]),
  response: layout([
    count('byteCount', {
      // A server id of at least one byte and the run indicator; the PDU's 253 bytes less function code and this count.
      least: 2,
      most: 251,
      derive: ({ data }) => (typeof data === 'string' ? data.replace(/\s/g, '').length / 2 : undefined),
    }),
    hex('data', {
      size: (seen) => stated('byteCount', seen),
      rules: [() => ({ code: 'server-id-layout-open', severity: 'note' })],
    }),
  ]),
});
