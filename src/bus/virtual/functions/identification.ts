import { fromHex, MOST_PDU, toHex } from '../../../modbus/index.ts';
import type { Device } from '../device.ts';
import { handle, noSuchAddress, reply } from './handler.ts';

// While a person edits an object, its text may not be pairs of digits.
export const serverId = handle(0x11, ({ serverId }) =>
  reply({ data: fromHex(serverId) === undefined ? '' : serverId }),
);

const MEI_IDENTIFICATION = 0x0e;
const ONE_OBJECT = 0x04;
const INDIVIDUAL = 0x80;
const MORE = 0xff;
/** By read device id code, the last object of its category: basic, regular, extended (AP 6.21). */
const LAST_OBJECT: Readonly<Record<number, number>> = { 1: 0x02, 2: 0x7f, 3: 0xff };
/** Function code, MEI type, and five bytes before the objects; id and length before each value. */
const BEFORE_OBJECTS = 7;
const BEFORE_VALUE = 2;
const MOST_VALUE = 244;
const LAST_ASCII = 0x7f;
const QUESTION_MARK = 0x3f;

interface Named {
  readonly objectId: number;
  readonly valueHex: string;
}

const valueHex = (text: string) =>
  toHex(
    Uint8Array.from(text.slice(0, MOST_VALUE), (character) => {
      const code = character.charCodeAt(0);
      return code > LAST_ASCII ? QUESTION_MARK : code;
    }),
  );

/** 2B/0E. Of 2B, nothing else is known: what 0D carries is CiA's. */
export const identification = handle(
  0x2b,
  (device, { meiType }, { fields }) => {
    const readDeviceIdCode = fields['readDeviceIdCode'] as number;
    const objectId = fields['objectId'] as number;
    const { objects, conformityLevel } = device;
    const answer = (found: readonly Named[], next?: number) =>
      reply({
        meiType,
        readDeviceIdCode,
        conformityLevel,
        moreFollows: next === undefined ? 0 : MORE,
        nextObjectId: next ?? 0,
        objects: found,
      });
    if (readDeviceIdCode === ONE_OBJECT) {
      const text = objects.get(objectId);
      const alone = (conformityLevel & INDIVIDUAL) !== 0;
      return text === undefined || !alone ? noSuchAddress : answer([{ objectId, valueHex: valueHex(text) }]);
    }
    const all = streamed(device, readDeviceIdCode, objectId);
    const fitting = all.slice(0, fittingOf(all));
    return fitting.length === 0 ? noSuchAddress : answer(fitting, all[fitting.length]?.objectId);
  },
  { knows: ({ fields }) => fields['meiType'] === MEI_IDENTIFICATION },
);

/** The objects of a category from one on, or from the first if it does not exist. Never above the device's own level. */
function streamed({ objects, conformityLevel }: Device, code: number, from: number): readonly Named[] {
  const level = Math.min(code, conformityLevel & ~INDIVIDUAL);
  const ids = [...objects.keys()].filter((id) => id <= (LAST_OBJECT[level] ?? 0)).sort((a, b) => a - b);
  const first = Math.max(0, ids.indexOf(from));
  return ids.slice(first).map((objectId) => ({ objectId, valueHex: valueHex(objects.get(objectId) ?? '') }));
}

/** How many of the objects fit into one reply; none is split. */
function fittingOf(all: readonly Named[]): number {
  let length = BEFORE_OBJECTS;
  const over = all.findIndex((object) => {
    length += BEFORE_VALUE + object.valueHex.length / 2;
    return length > MOST_PDU;
  });
  return over < 0 ? all.length : over;
}
