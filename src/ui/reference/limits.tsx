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
import { codeCell, type Entry, frameLink, type Say, sectionCell } from './entry.tsx';
import { digits, labelOf, legalOf } from './layout.tsx';

export function sizeEntries(say: Say): readonly Entry[] {
  const { text, page } = say;
  const { sizes } = text;
  const entry = (transport: keyof typeof sizes, most: string, madeOf: string, section: SpecSection): Entry => ({
    key: transport,
    cells: [page.page.transports[transport], <b key="most">{most}</b>, madeOf, sectionCell(say, section)],
  });
  return [
    entry('pdu', text.bytes(MOST_PDU), sizes.pdu(MOST_PDU), 'AP 4.1'),
    entry('rtu', text.bytes(MOST_RTU), sizes.rtu(MOST_PDU), 'SL 2.5.1'),
    entry('ascii', text.characters(MOST_ASCII), sizes.ascii(MOST_PDU), 'SL 2.5.2.1'),
    entry('tcp', text.bytes(MBAP + MOST_PDU), sizes.tcp(MOST_PDU, MBAP), 'AP 4.1'),
  ];
}

export const limitEntries = (say: Say): readonly Entry[] =>
  functionCodes.flatMap((description: FunctionCode) =>
    limitedFields(description).map((found) => limitEntry(description, found, say)),
  );

function limitEntry(description: FunctionCode, found: LimitedField, say: Say): Entry {
  const { text, page } = say;
  const { code, name } = description;
  const { direction, field, section, typed } = found;
  const { range, width } = field;
  const kind = direction === 'request' ? 'request' : 'reply';
  const side = page.page.directions[direction];
  const label = labelOf(say, field.name);
  // The frame at its limit, where that can be typed.
  const texts = { functionCode: code, ...(typed && range && { [field.name]: range.most }) };
  return {
    key: `${code} ${direction} ${field.name}`,
    codes: [code],
    cells: [
      codeCell(text.code(code), name),
      side,
      frameLink({ kind, texts }, label, text.fieldIn(label, code, name, side)),
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
