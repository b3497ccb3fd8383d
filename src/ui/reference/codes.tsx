import { codeFault, codeRange, describeFunction, exceptionCodes, rawFunction, vendorOf } from '../../modbus/index.ts';
import type { ReferenceWords } from '../../words/index.ts';
import { type CodeRun, codeRuns, sectionOfProblem } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';
import { codeCell, type Entry, frameLink, type Section, sectionCell } from './entry.tsx';
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
          sectionCell(sectionOfProblem(example, 'exceptionCode') ?? describeFunction(0x80, 'response').section),
        ],
      };
    }),
  };
}

/** The 256 codes: public, free for anybody, reserved, and unassigned. */
export function rangeSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  return { subject: 'ranges', columns: [c.code, c.range, c.user, c.section], entries: codeRuns().map(rangeEntry) };
}

function rangeEntry([first, last]: CodeRun): Entry {
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
