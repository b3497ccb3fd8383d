import {
  type FunctionCode,
  functionCodes,
  MBAP,
  MOST_ASCII,
  MOST_PDU,
  MOST_RTU,
  type Section as SpecSection,
} from '../../modbus/index.ts';
import { type LimitedField, limitedFields } from '../../workbench/index.ts';
import { codeCell, type Entry, frameLink, type Say, type Section, sectionCell } from './entry.tsx';
import { digits, labelOf, legalOf } from './layout.tsx';

export function sizeSection(say: Say): Section {
  const { text, page } = say;
  const { columns: c, sizes } = text;
  const entry = (transport: keyof typeof sizes, most: string, madeOf: string, section: SpecSection): Entry => ({
    key: transport,
    codes: [],
    also: 'length maximum limit',
    cells: [page.page.transports[transport], <b key="most">{most}</b>, madeOf, sectionCell(say, section)],
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

export function limitSection(say: Say): Section {
  const { columns: c } = say.text;
  return {
    subject: 'limits',
    columns: [c.function, c.direction, c.field, c.legal, c.hex, c.section],
    entries: functionCodes.flatMap((description: FunctionCode) =>
      limitedFields(description).map((found) => limitEntry(description, found, say)),
    ),
  };
}

function limitEntry(description: FunctionCode, found: LimitedField, say: Say): Entry {
  const { text } = say;
  const { code, name } = description;
  const { direction, field, section, typed } = found;
  const { range, width } = field;
  const kind = direction === 'request' ? 'request' : 'reply';
  const label = labelOf(say, field.name);
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
        {legalOf(field, say)}
      </span>,
      <span key="hex" class="mono soft">
        {range && `${digits(range.least, width)}–${digits(range.most, width)}`}
      </span>,
      sectionCell(say, section),
    ],
  };
}
