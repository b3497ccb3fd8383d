import { layout } from '../field.ts';
import { count } from '../fields/number.ts';
import { hex } from '../fields/raw-bytes.ts';
import { defineFunction } from '../function-code.ts';
import { fromHex } from '../hex.ts';

export const reportServerId = defineFunction({
  code: 0x11,
  name: 'Report Server ID',
  section: 'AP 6.13',
  group: 'identification',
  access: 'reads',
  probe: {},
  serialOnly: true,
  request: layout([]),
  response: layout([
    count('byteCount', {
      // Whether it counts more than the server id is open; at most the PDU's 253 bytes less function code and this count.
      least: 1,
      most: 251,
      derive: ({ data }) => (typeof data === 'string' ? fromHex(data)?.length : undefined),
    }),
    hex('data', {
      size: ({ count }) => count,
      rules: [() => ({ code: 'server-id-layout-open', severity: 'note' })],
    }),
  ]),
});
