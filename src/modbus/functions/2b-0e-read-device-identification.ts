import { layout, type Rule, type Values } from '../field.ts';
import { groups } from '../fields/groups.ts';
import { choice, count, echoes, lengthOf, u8 } from '../fields/number.ts';
import { acceptHex, hex } from '../fields/raw-bytes.ts';
import { FrameError } from '../frame-error.ts';
import { fromHex, toHex } from '../hex.ts';

const SECTION = 'AP 6.21';

/** A server may answer at its own, lower level. 01 basic, 02 regular, 03 extended: streams; 04 one object. */
const readDeviceIdCode = choice('readDeviceIdCode', [1, 2, 3, 4], { replyRules: [echoes('readDeviceIdCode', 'note')] });

/** 00…06 have names, 80…FF are private, those between are reserved. */
const objectIdReserved: Rule<number> = (got) =>
  got >= 0x07 && got <= 0x7f ? { code: 'object-id-reserved', severity: 'warning', got } : undefined;
const objectId = u8('objectId', { kind: 'choice', rules: [objectIdReserved] });

/** An object is never split, so the PDU's 253 bytes less nine others bound it. */
const MOST_VALUE = 244;

const object = [
  objectId,
  count('length', {
    least: 0,
    most: MOST_VALUE,
    derive: ({ valueHex }) => (typeof valueHex === 'string' ? valueHex.length / 2 : undefined),
  }),
  hex('valueHex', { size: ({ count }) => count }),
];

const isPrintable = (byte: number) => byte >= 0x20 && byte < 0x7f;

/** Adds the text of a value that is printable ASCII throughout. */
function showValue(fields: Values): Values {
  const bytes = fromHex(fields['valueHex'] as string) ?? new Uint8Array();
  return bytes.every(isPrintable) ? { ...fields, value: String.fromCharCode(...bytes) } : fields;
}

/** Takes the value's bytes from `valueHex`, else from the text `value`. */
function hideValue({ objectId, valueHex, value }: Values, path: string): Values {
  if (valueHex !== undefined || value === undefined) {
    return { objectId, valueHex: acceptHex(valueHex, `${path}.valueHex`) };
  }
  const text = String(value);
  const bytes = Uint8Array.from(text, (character) => character.charCodeAt(0));
  if (Array.from(text).some((character) => character.charCodeAt(0) > 0x7f)) {
    throw new FrameError(`${path}.value`, { code: 'not-ascii', got: value });
  }
  return { objectId, valueHex: toHex(bytes) };
}

/** Individual access gives the object that was asked for, and no other (AP 6.21). */
const INDIVIDUAL = 4;
const objectAsAsked: Rule<readonly Values[]> = (objects, { fields, request }) => {
  if (request?.fields['readDeviceIdCode'] !== INDIVIDUAL || fields['readDeviceIdCode'] !== INDIVIDUAL) return undefined;
  const isAsked = objects.length === 1 && objects[0]?.['objectId'] === request.fields['objectId'];
  return isAsked ? undefined : { code: 'echo-differs', severity: 'error', field: 'objectId' };
};

const MORE = 0xff;

/** With nothing more to follow, the next object id is 00. */
const nextObjectId: Rule<number> = (got, { fields }) =>
  got !== 0 && fields['moreFollows'] === 0 ? { code: 'next-object-not-zero', severity: 'error', got } : undefined;

export const readDeviceIdentification = {
  meiType: 0x0e,
  name: 'Read Device Identification',
  section: SECTION,
  access: 'reads',
  request: layout([readDeviceIdCode, objectId], undefined, SECTION),
  response: layout(
    [
      readDeviceIdCode,
      choice('conformityLevel', [0x01, 0x02, 0x03, 0x81, 0x82, 0x83]),
      choice('moreFollows', [0x00, MORE]),
      u8('nextObjectId', { rules: [nextObjectId] }),
      count('numberOfObjects', { kind: 'quantity', least: 1, most: 123, derive: lengthOf('objects') }),
      groups('objects', object, {
        number: ({ items }) => items,
        // The text counts the objects of this reply, the example those of the whole stream (AP 6.21).
        fewer: {
          by: 'numberOfObjects',
          fault: ({ fields, items }) => ({
            code: 'object-count-differs',
            severity: fields['moreFollows'] === MORE ? 'note' : 'warning',
            got: items,
            expected: (fields['objects'] as readonly unknown[]).length,
          }),
        },
        replyRules: [objectAsAsked],
        show: showValue,
        hide: hideValue,
      }),
    ],
    undefined,
    SECTION,
  ),
} as const;
