import {
  type Direction,
  type Field,
  type FunctionCode,
  functionCodes,
  type Layout,
  MBAP,
  MOST_ASCII,
  MOST_PDU,
  MOST_RTU,
  type Section as SpecSection,
} from '../../modbus/index.ts';
import type { ReferenceWords } from '../../words/index.ts';
import { words } from '../language.ts';
import { codeCell, type Entry, frameLink, type Section, sectionCell } from './entry.tsx';
import { digits, labelOf, legalOf } from './layout.tsx';

export function sizeSection(text: ReferenceWords): Section {
  const { columns: c, sizes } = text;
  const entry = (transport: keyof typeof sizes, most: string, madeOf: string, section: SpecSection): Entry => ({
    key: transport,
    codes: [],
    also: 'length maximum limit',
    cells: [words.page.transports[transport], <b key="most">{most}</b>, madeOf, sectionCell(section)],
  });
  return {
    subject: 'sizes',
    columns: [c.frame, c.most, c.madeOf, c.section],
    entries: [
      entry('pdu', text.bytes(MOST_PDU), sizes.pdu(MOST_PDU), 'AP 4.1'),
      entry('rtu', text.bytes(MOST_RTU), sizes.rtu(MOST_PDU), 'SL 2.5.1'),
      entry('ascii', text.characters(MOST_ASCII), sizes.ascii(MOST_PDU), 'SL 2.5.2.1'),
      entry('tcp', text.bytes(MBAP + MOST_PDU), sizes.tcp(MOST_PDU, MBAP), 'AP 4.1'),
    ],
  };
}

/** A field with its limits, and where it stands. */
interface Limited {
  readonly field: Field;
  readonly section: SpecSection;
  /** Whether it is typed on its own: not worked out by the encoder, and in no group. */
  readonly typed: boolean;
}

/** The fields of a layout that hold less than fits, those of groups and of choices too. */
function* limited(layout: Layout, section: SpecSection): Generator<Limited> {
  const stands = layout.section ?? section;
  for (const field of layout.fields) {
    if (field.range) yield { field, section: stands, typed: field.derive === undefined };
    for (const inner of field.group ?? []) if (inner.range) yield { field: inner, section: stands, typed: false };
  }
  for (const following of Object.values(layout.then?.cases ?? {})) yield* limited(following, stands);
}

export function limitSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  return {
    subject: 'limits',
    columns: [c.function, c.direction, c.field, c.legal, c.hex, c.section],
    entries: functionCodes.flatMap((description: FunctionCode) => {
      const ofLayout = (direction: Direction) =>
        Array.from(limited(description[direction], description.section), (found) =>
          limitEntry(description, direction, found, text),
        );
      // A reply that repeats its request has the same limits.
      const repeats = description.request === description.response;
      return [...ofLayout('request'), ...(repeats ? [] : ofLayout('response'))];
    }),
  };
}

function limitEntry(description: FunctionCode, direction: Direction, found: Limited, text: ReferenceWords): Entry {
  const { code, name } = description;
  const { field, section, typed } = found;
  const { range, width } = field;
  const kind = direction === 'request' ? 'request' : 'reply';
  const label = labelOf(field.name);
  // The frame at its limit, where that can be typed.
  const texts = { functionCode: code, ...(typed && range && { [field.name]: range.most }) };
  return {
    key: `${code} ${direction} ${field.name}`,
    codes: [code],
    also: 'limit maximum fc',
    cells: [
      codeCell(digits(code), name),
      text[kind].toLowerCase(),
      frameLink({ kind, texts }, label, text.fieldIn(label, code, name, text[kind].toLowerCase())),
      <span key="legal" class="mono">
        {legalOf(field)}
      </span>,
      <span key="hex" class="mono soft">
        {range && `${digits(range.least, width)}–${digits(range.most, width)}`}
      </span>,
      sectionCell(section),
    ],
  };
}
