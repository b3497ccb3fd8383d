import {
  BROADCAST,
  envelopeSection,
  FIRST_UNIT,
  type FunctionCode,
  functionCodes,
  functionsOf,
  LAST_ADDRESS,
  LAST_UNIT,
  type Table,
  TCP_DIRECT,
} from '../../modbus/index.ts';
import { entityNumber, formatHex, sixDigitNumber } from '../../notation/index.ts';
import { codeCell, type Entry, frameLink, type Say, sectionCell } from './entry.tsx';
import { digits } from './layout.tsx';

const functions: readonly FunctionCode[] = functionCodes;
const LAST_BYTE = 0xff;

/** What a unit identifier means on a serial line and over TCP. */
export function unitEntries(say: Say): readonly Entry[] {
  const { text } = say;
  const { unitMeanings: means } = text;
  const agreed = functions.filter(({ broadcast }) => broadcast);
  const entry = (transport: 'rtu' | 'tcp', first: number, last: number, meaning: string): Entry => {
    const decimal = first === last ? String(first) : `${first}–${last}`;
    const line = transport === 'tcp' ? text.tcp : text.serialLine;
    const toAll = transport === 'rtu' && first === BROADCAST ? agreed[0] : undefined;
    const texts = { unitId: first, functionCode: toAll?.code ?? 0x03 };
    return {
      key: `${transport} ${first}`,
      codes: [first, last],
      cells: [
        codeCell(decimal, first === last ? digits(first) : `${digits(first)}–${digits(last)}`),
        frameLink({ transport, texts }, line, text.unitOn(line, decimal)),
        meaning,
        sectionCell(say, envelopeSection(transport, 'unitId')),
      ],
    };
  };
  return [
    entry('rtu', BROADCAST, BROADCAST, means.broadcast(agreed.map(({ code }) => say.text.code(code)).join(', '))),
    entry('rtu', FIRST_UNIT, LAST_UNIT, means.single),
    entry('rtu', LAST_UNIT + 1, LAST_BYTE, means.reserved),
    entry('tcp', TCP_DIRECT, TCP_DIRECT, means.direct),
    entry('tcp', BROADCAST, BROADCAST, means.tcpZero),
    entry('tcp', FIRST_UNIT, LAST_UNIT, means.behind),
    entry('tcp', LAST_UNIT + 1, TCP_DIRECT - 1, means.unspecified),
  ];
}

/** The last address that five digits have room for. */
const LAST_OF_FIVE = 9998;
/** The last record of a file (AP 6.14). */
const LAST_RECORD = 9999;
/** Register 108, which the specification's own read of holding registers begins with. */
const EXAMPLE = 0x006b;

const TABLES: readonly Table[] = ['coil', 'discrete-input', 'input-register', 'holding-register', 'file-record'];

/** The numbers that manuals print for addresses. */
export const numberingEntries = (say: Say): readonly Entry[] => TABLES.map((table) => numberingEntry(table, say));

function numberingEntry(table: Table, say: Say): Entry {
  const { text, page } = say;
  const used = functionsOf(table);
  const files = table === 'file-record';
  const texts = { functionCode: used[0]?.code ?? 0, startAddress: EXAMPLE };
  return {
    key: table,
    cells: [
      frameLink({ texts }, page.tables[table].many),
      text.access[table],
      files
        ? text.fileNumbers
        : numbers(
            `${entityNumber(table, 0)}–${entityNumber(table, LAST_OF_FIVE)}`,
            text.example(formatHex(EXAMPLE, 4), entityNumber(table, EXAMPLE)),
          ),
      numbers(`${sixDigitNumber(table, 0)}–${sixDigitNumber(table, files ? LAST_RECORD : LAST_ADDRESS)}`),
      <span key="functions" class="mono">
        {used.map(({ code }) => text.code(code)).join(', ')}
      </span>,
      sectionCell(say, files ? 'AP 6.14' : 'PI ch. 2'),
    ],
  };
}

const numbers = (range: string, beside?: string) => (
  <>
    <span class="mono">{range}</span>
    {beside !== undefined && <small>{beside}</small>}
  </>
);
