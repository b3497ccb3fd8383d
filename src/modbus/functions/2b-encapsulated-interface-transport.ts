import { layout } from '../field.ts';
import { echoes, u8 } from '../fields/number.ts';
import { hex } from '../fields/raw-bytes.ts';
import { defineFunction } from '../function-code.ts';
import { canopenGeneralReference } from './2b-0d-canopen-general-reference.ts';
import { readDeviceIdentification } from './2b-0e-read-device-identification.ts';

/** The MEI types in use (AP 6.19); every other is reserved (AP Annex A). */
export const meiTypes = [canopenGeneralReference, readDeviceIdentification] as const;

const meiType = u8('meiType', {
  kind: 'choice',
  allowed: meiTypes.map(({ meiType }) => meiType),
  rules: [
    (got) =>
      meiTypes.some(({ meiType }) => meiType === got)
        ? undefined
        : { code: 'mei-type-reserved', severity: 'warning', got, section: 'AP Annex A' },
  ],
  replyRules: [echoes('meiType')],
});

const otherwise = layout([hex('meiData')]);
const cases = (direction: 'request' | 'response') =>
  Object.fromEntries(meiTypes.map((type) => [type.meiType, type[direction]]));

export const encapsulatedInterfaceTransport = defineFunction({
  code: 0x2b,
  name: 'Encapsulated Interface Transport',
  section: 'AP 6.19',
  group: 'identification',
  access: {
    by: 'meiType',
    reads: meiTypes.filter(({ access }) => access === 'reads').map(({ meiType }) => meiType),
  },
  // The basic objects of the identification, from the first on.
  probe: { meiType: readDeviceIdentification.meiType, readDeviceIdCode: 1, objectId: 0 },
  request: layout([meiType], { by: 'meiType', cases: cases('request'), otherwise }),
  response: layout([meiType], { by: 'meiType', cases: cases('response'), otherwise }),
});
