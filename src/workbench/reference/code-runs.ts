import { codeRange, vendorOf } from '../../modbus/index.ts';

/** Neighbouring function codes of which the same is said, from the first to the last. */
export type CodeRun = readonly [first: number, last: number];

/** The 256 codes in runs of one range (`codeRange`) and one known user. */
export function codeRuns(): CodeRun[] {
  const found: CodeRun[] = [];
  const same = (a: number, b: number) => codeRange(a) === codeRange(b) && vendorOf(a) === vendorOf(b);
  for (let first = 0; first < 256; ) {
    let last = first;
    while (last < 255 && same(first, last + 1)) last++;
    found.push([first, last]);
    first = last + 1;
  }
  return found;
}
