import { type CodeRange, codeRange, diagnosticSubFunctions, functionCodes, meiTypes } from '../../modbus/index.ts';
import { formatHex, readNumber } from '../../notation/index.ts';

/** A function, sub-function or MEI type, or a code without a name, and the texts of a draft that choose it. */
export interface FoundFunction {
  /** Its code and its name in the specification: `03 Read Holding Registers`, `2B/0E Read Device Identification`. */
  readonly name: string;
  readonly code: number;
  /** Of a code without a name: who it is for. */
  readonly range?: CodeRange;
  readonly texts: Readonly<Record<string, string>>;
}

/** Longest list of finds. */
const MOST = 8;

const digits = (code: number) => formatHex(code, 2).slice(2);

const everything: readonly FoundFunction[] = [
  ...functionCodes.map(({ code, name }) => ({
    code,
    name: `${digits(code)} ${name}`,
    texts: { functionCode: String(code) },
  })),
  ...meiTypes.map(({ meiType, name }) => ({
    code: 0x2b,
    name: `2B/${digits(meiType)} ${name}`,
    texts: { functionCode: '43', meiType: String(meiType) },
  })),
  ...diagnosticSubFunctions.map(({ code, name }) => ({
    code: 0x08,
    name: `08/${digits(code)} ${name}`,
    texts: { functionCode: '8', subFunction: String(code) },
  })),
];

/**
 * What a name, or a code in decimal or hexadecimal, may mean: at most eight. A code that was typed comes before a name that
 * happens to hold its digits.
 */
export function findFunctions(query: string): readonly FoundFunction[] {
  const text = query.trim().toLowerCase();
  if (text === '') return [];
  const asHex = /^[0-9a-f]{1,2}$/.test(text) ? Number.parseInt(text, 16) : 0;
  const codes = [readNumber(text) ?? 0, asHex].filter((code) => code > 0 && code <= 0x7f);
  const isMeant = ({ code }: FoundFunction) => codes.includes(code);
  const unnamed = [...new Set(codes)]
    .map((code) => ({
      code,
      name: `${digits(code)}, ${code}`,
      range: codeRange(code),
      texts: { functionCode: String(code) },
    }))
    .filter(({ range }) => range !== 'public');
  return [
    ...everything.filter(isMeant),
    ...everything.filter((found) => !isMeant(found) && found.name.toLowerCase().includes(text)),
    ...unnamed,
  ].slice(0, MOST);
}
