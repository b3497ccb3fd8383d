import { codeFault, codeRange, describeFunction, exceptionCodes, rawFunction, vendorOf } from '../../modbus/index.ts';
import { type CodeRun, codeRuns, sectionOfProblem } from '../../workbench/index.ts';
import { codeCell, type Entry, frameLink, type Say, sectionCell } from './entry.tsx';
import { digits } from './layout.tsx';

/** The function whose refusal the examples are. */
const REFUSED = 0x03;

export const exceptionEntries = (say: Say): readonly Entry[] =>
  exceptionCodes.map(({ code, name }) => {
    const example = { kind: 'exception', texts: { functionCode: REFUSED, exceptionCode: code } } as const;
    return {
      key: String(code),
      codes: [code],
      cells: [
        codeCell(digits(code), code),
        frameLink(example, name),
        say.page.choices['exceptionCode']?.[code]?.hint ?? '',
        sectionCell(say, sectionOfProblem(example, 'exceptionCode') ?? describeFunction(0x80, 'response').section),
      ],
    };
  });

/** The 256 codes: public, free for anybody, reserved, and unassigned. */
export const rangeEntries = (say: Say): readonly Entry[] => codeRuns().map((run) => rangeEntry(run, say));

function rangeEntry([first, last]: CodeRun, say: Say): Entry {
  const range = codeRange(first);
  const hex = first === last ? digits(first) : `${digits(first)}–${digits(last)}`;
  const name = say.page.page.codeRanges[range];
  return {
    key: String(first),
    codes: [[first, last]],
    cells: [
      codeCell(hex, first === last ? first : `${first}–${last}`),
      <span key="range" class="range" data-range={range}>
        {frameLink({ texts: { functionCode: first } }, name, `${name}, ${hex}`)}
      </span>,
      vendorOf(first) ?? '',
      sectionCell(say, codeFault(first)?.section ?? rawFunction.section),
    ],
  };
}
