import { codeFault, codeRange, describeFunction, exceptionCodes, rawFunction, vendorOf } from '../../modbus/index.ts';
import type { ReferenceWords } from '../../words/index.ts';
import { words } from '../language.ts';
import { codeCell, type Entry, frameLink, type Section, sectionCell } from './entry.tsx';
import { reservedBy } from './functions.tsx';
import { digits } from './layout.tsx';

/** The function whose refusal the examples are. */
const REFUSED = 0x03;

export function exceptionSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  return {
    subject: 'exceptions',
    columns: [c.code, c.name, c.means, c.section],
    entries: exceptionCodes.map(({ code, name }) => {
      const example = { kind: 'exception', texts: { functionCode: REFUSED, exceptionCode: code } } as const;
      return {
        key: String(code),
        codes: [code],
        also: 'exception',
        cells: [
          codeCell(digits(code), code),
          frameLink(example, name),
          words.choices['exceptionCode']?.[code]?.hint ?? '',
          sectionCell(reservedBy(example, 'exceptionCode') ?? describeFunction(0x80, 'response').section),
        ],
      };
    }),
  };
}

/** Neighbouring codes of which the same is to be said, from the first to the last. */
type Run = readonly [number, number];

function runs(): Run[] {
  const found: Run[] = [];
  const same = (a: number, b: number) => codeRange(a) === codeRange(b) && vendorOf(a) === vendorOf(b);
  for (let first = 0; first < 256; ) {
    let last = first;
    while (last < 255 && same(first, last + 1)) last++;
    found.push([first, last]);
    first = last + 1;
  }
  return found;
}

/** The 256 codes: public, for whoever wants them, reserved, and none. */
export function rangeSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  return { subject: 'ranges', columns: [c.code, c.range, c.user, c.section], entries: runs().map(rangeEntry) };
}

function rangeEntry([first, last]: Run): Entry {
  const range = codeRange(first);
  const hex = first === last ? digits(first) : `${digits(first)}–${digits(last)}`;
  const name = words.page.codeRanges[range];
  return {
    key: String(first),
    codes: [[first, last]],
    also: 'range',
    cells: [
      codeCell(hex, first === last ? first : `${first}–${last}`),
      <span key="range" class="range" data-range={range}>
        {frameLink({ texts: { functionCode: first } }, name, `${name}, ${hex}`)}
      </span>,
      vendorOf(first) ?? '',
      sectionCell(codeFault(first)?.section ?? rawFunction.section),
    ],
  };
}
