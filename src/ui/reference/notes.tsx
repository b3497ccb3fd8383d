import type { Misprint, ReferenceWords } from '../../words/index.ts';
import { type Entry, type Example, frameLink, type Section, sectionCell } from './entry.tsx';

type Point = keyof ReferenceWords['openPoints'];

/** Frames in which the question comes up, where one can be shown. */
const EXAMPLES: Readonly<Partial<Record<Point, Example>>> = {
  coilValue: { texts: { functionCode: 5 }, force: { rawValue: '1' } },
  padding: { texts: { functionCode: 15, bits: '1 0 1' }, force: { padding: '1' } },
  queryData: { texts: { functionCode: 8, subFunction: 0, data: '12 34 56 78' } },
  listenOnly: { texts: { functionCode: 8, subFunction: 4 } },
  readFileLengths: { kind: 'reply', texts: { functionCode: 20, 'subResponses[0].recordData': '1' } },
  writeFileLength: { texts: { functionCode: 21 } },
  fifo: { texts: { functionCode: 24, fifoPointerAddress: '0x04DE' } },
  objectCount: { kind: 'reply', texts: { functionCode: 43, meiType: 14 }, force: { numberOfObjects: '3' } },
  canopen: { texts: { functionCode: 43, meiType: 13 } },
  serverId: { kind: 'reply', texts: { functionCode: 17, data: '01 FF 41 42' } },
  tcpUnit: { transport: 'tcp', texts: { unitId: 0, functionCode: 3 } },
  lrc: { transport: 'ascii', texts: { unitId: 10, functionCode: 1, startAddress: '0x04A1' } },
  oldLimits: { texts: { functionCode: 16, registers: '0 '.repeat(101).trim() } },
  mask: { texts: { functionCode: 22, andMask: '0x00F2', orMask: '0x0025' } },
  writeThenRead: { texts: { functionCode: 23 } },
  programFunctions: { texts: { functionCode: 13 } },
  reservedSubFunctions: { texts: { functionCode: 8, subFunction: '0x13' } },
};

/** What the specification leaves open. */
export function openSection(text: ReferenceWords): Section {
  const { columns: c, openPoints } = text;
  return {
    subject: 'open',
    columns: [c.point, c.known, c.section],
    entries: (Object.keys(openPoints) as Point[]).map((key) => {
      const { title, text: known, sections } = openPoints[key];
      const example = EXAMPLES[key];
      return {
        key,
        codes: [],
        also: 'ambiguous open',
        cells: [example ? frameLink(example, title) : title, known, sectionCell(...sections)],
      };
    }),
  };
}

/** Errors in print: those of the specifications, and those of everybody else. */
export function misprintSections(text: ReferenceWords): Section[] {
  const { columns: c } = text;
  const columns = [c.source, c.printed, c.right, c.why, c.gravity];
  const entries = (specification: boolean) =>
    text.misprints
      .filter((misprint) => (misprint.specification === true) === specification)
      .map((misprint, index) => misprintEntry(misprint, index, text));
  return [
    { subject: 'misprints', columns, entries: entries(true) },
    { subject: 'published', columns, entries: entries(false) },
  ];
}

const TONES = { wrong: 'error', ambiguous: 'warning', note: 'note' } as const;

function misprintEntry(misprint: Misprint, index: number, text: ReferenceWords): Entry {
  const { where, printed, kind, why, right, gravity, onPurpose } = misprint;
  return {
    key: String(index),
    codes: [],
    also: 'misprint',
    cells: [
      where,
      asPrinted(printed),
      asPrinted(right),
      <>
        <b>{`${kind.charAt(0).toUpperCase()}${kind.slice(1)}.`}</b> {why}
        {onPurpose && <small>{text.onPurpose}</small>}
      </>,
      <span key="gravity" class="gravity" data-severity={TONES[gravity]}>
        {text.gravities[gravity]}
      </span>,
    ],
  };
}

/** Bytes in the type of bytes, words as they are. */
const asPrinted = (printed: string) =>
  /^:?[0-9A-F ]{4,}$/.test(printed) ? <span class="mono">{printed}</span> : printed;
