import { addressIn, byteHex, plural } from './common.ts';

/** What is said where the items of a list, or coils, are edited one by one. */
export const oneByOne = {
  listIs: (count: number) => `${plural(count, 'item')}, decimal or hexadecimal`,
  listHint: 'Decimal or hexadecimal, separated by blanks, commas or lines.',
  bitsAre: (count: number, bytes: string) => `${plural(count, 'bit')}, lowest address first: ${bytes}`,
  bitsHint: '1 and 0, the lowest address first.',
  octetsHint: 'Hexadecimal pairs, or text in double quotes.',
  coils: {
    oneByOne: 'One by one',
    coil: (address: number) => `Address ${addressIn(address)}`,
    byteOf: (place: number) => `Byte ${place} of these bits`,
    count: 'How many',
    asBytes: 'As bytes',
    firstByte: 'first byte',
    orderIs: 'A byte is printed with its highest bit first: the lowest address stands last.',
    /** What the picture of the first byte shows. */
    order: (first: number, byte: number) =>
      `The lowest address, ${addressIn(first)}, is the lowest bit of the first byte, which is printed last: ${byte.toString(2).padStart(8, '0')}, ${byteHex(byte)}.`,
    pageOf: (first: number, last: number, all: number) => `${first}–${last} of ${plural(all, 'bit')}`,
    earlier: 'Earlier bits',
    later: 'Later bits',
    atFirst: 'These are the first bits.',
    atLast: 'These are the last bits.',
  },
  items: 'Edit one by one',
  item: (index: number, address: number | undefined) =>
    address === undefined ? `Item ${index + 1}` : `Item ${index + 1}, address ${addressIn(address)}`,
  itemShort: (index: number, address: number | undefined) => String(address ?? index + 1),
  up: (index: number) => `Move item ${index + 1} up`,
  down: (index: number) => `Move item ${index + 1} down`,
  remove: (index: number) => `Remove item ${index + 1}`,
  add: 'Add an item',
  fill: 'Fill',
  fillCount: 'Number of items',
  fillValue: 'First value',
  fillStep: 'Step',
  pageOf: (first: number, last: number, all: number) => `${first}–${last} of ${plural(all, 'item')}`,
  earlier: 'Earlier items',
  later: 'Later items',
  atFirst: 'This is the first item.',
  atLast: 'This is the last item.',
};
