import type { Confidence, Identity } from '../../diagnosis/index.ts';
import type { SerialLine } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { InputAdvice, InputOffer } from '../../workbench/index.ts';
import { numbered } from './address.ts';
import { controllers } from './address-ways.ts';
import { asked } from './asked.ts';
import { bytesOf, code, elementIn, fields, page, plural, views, word } from './common.ts';
import { identify } from './identify.ts';
import { pasting } from './pasting.ts';

const confidences: Readonly<Record<Confidence, string>> = {
  certain: 'Certain',
  likely: 'Likely',
  possible: 'Possible',
};

/** What a text is taken for, after “Taken” or alone on a button. */
function offered(offer: InputOffer): string {
  switch (offer.as) {
    case 'function':
      return `as function ${page.functionIn(offer)}`;
    case 'bytes':
      return `as bytes ${formatBytes(offer.bytes)}`;
    case 'values':
      return `as ${plural(offer.registers.length, 'register')}: ${offer.registers.join(', ')}`;
    case 'number':
      return `as ${typeOf(offer)}: ${offer.registers.map(word).join(' ')}`;
    case 'unit':
      return `as unit ${offer.unit}`;
    case 'address':
      return request(offer);
  }
}

const typeOf = ({ number, type, order }: Extract<InputOffer, { as: 'number' }>): string =>
  !type.endsWith('16') ? `${type} ${order} ${number}` : `${type} ${number}`;

/** `as 3 from register 40108 (address 107), unit 17`, `as 4096 to register 40684 (address 683)`. */
function request(offer: Extract<InputOffer, { as: 'address' }>): string {
  const { table, address, sixDigits, name, device, quantity, value, unit, bit, plc, isWide } = offer;
  const element =
    plc === undefined
      ? elementIn(table, address, sixDigits)
      : `${numbered(table, address)} = address ${address} = ${word(address)}`;
  const named = name === undefined ? element : `${name} of ${device}: ${element}`;
  const place = bit === undefined ? named : `bit ${bit} of ${named}`;
  // Whoever asks for one bit, or for a value without its type, sees which request that makes.
  const by =
    value !== undefined && (bit !== undefined || isWide)
      ? `, by function ${code(offer.code)}`
      : bit === undefined
        ? ''
        : ', whose other bits are read too';
  const does =
    value === ''
      ? 'a write to '
      : value !== undefined
        ? `${value} written to `
        : quantity === undefined
          ? ''
          : `${quantity} from `;
  return `as ${does}${place}${by}${unit === undefined ? '' : `, unit ${unit}`}${plc === undefined ? '' : `, ${controllers[plc]}`}`;
}

/** What is said where bytes are typed, pasted and read. */
export const read = {
  ...pasting,
  identity: identify.summary,
  confidences,
  found: (bytes: number, frames: number) => `${bytesOf(bytes)}, ${plural(frames, 'frame')}.`,
  openInLog: 'Open in the Log view',
  line: (line: number, column: number) => `Line ${line}, column ${column}`,
  moreProblems: (count: number) => `and ${plural(count, 'more place')}`,
  /** Unfolds the reasons for what the bytes were read as, and for what else they may be. */
  whatElse: 'Why',
  kindOf: ({ transport, direction }: Pick<Identity, 'transport' | 'direction'>) =>
    `${page.transports[transport]} ${pasting.directions[direction]}`,
  /** Before buttons with other readings of the text. */
  instead: 'Instead:',
  /** The frame that the text says, where another one is shown by now. */
  showAgain: 'Show this frame again',
  readSo: (what: string) => `Read as ${what}`,
  /** Before buttons with what the text may be. */
  severalMeanings: 'Take it',
  /** `unit` is the unit of the value, if nothing here says what it is in registers; buttons with the number alone follow. */
  takenForValue: (unit: string | undefined) =>
    unit === undefined
      ? 'Taken for a value.'
      : `Taken for a value in ${unit}: choose a device that has it, or say what full scale is. Or take the number alone`,
  taken: (offer: InputOffer) => `Taken ${offered(offer)}.`,
  offer: offered,
  /** A device that was chosen by a name in the text; `line` is the serial line that came with it. */
  chosen: (device: string, line: SerialLine | undefined) =>
    `${device} was chosen${line ? `, with its line ${views.lineName(line)}` : ''}.`,
  undo: 'Undo',
  undoChosen: (device: string) => `Undo: do not choose ${device}`,
  asked,
  advice: (advice: InputAdvice) =>
    advice.code === 'name-unknown'
      ? `“${advice.name}” is not the name of a register here. Type its address from 0 (107, 0x006B) or its number in manuals (40108, 4x108, HR108), or choose the device that has the name, or import its map:`
      : `Nothing writes ${fields.tables[advice.table].many}: a device only lets them be read. What can be written has numbers from 40001 (registers) and from 00001 (coils).`,
  toDevices: 'Devices',
  noAnswer: 'No reply to it? Find out why in the Bus view',
  useRepaired: 'Use the repaired frame',
};
