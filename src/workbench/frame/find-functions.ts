import { codeRange } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { everyFunction, type FoundFunction } from './functions-by-use.ts';

/** Longest list of finds. */
const MOST = 8;

/**
 * What a code or a name may mean: at most eight. Digits are decimal first, then hexadecimal; a code that was typed comes before
 * a name that happens to hold its digits. Words may be the beginnings of those in a name: `write reg`.
 */
export function findFunctions(query: string): readonly FoundFunction[] {
  const text = query.trim().toLowerCase();
  if (text === '') return [];
  const [typed, inPart] = text.split('/');
  const codes = codesIn(typed ?? '');
  const partCodes = inPart === undefined ? undefined : codesIn(inPart);
  const isMeant = ({ code, part }: FoundFunction, meant: number) =>
    code === meant && (partCodes === undefined || (part !== undefined && partCodes.includes(part)));
  const found = codes.flatMap((code) => everyFunction.filter((each) => isMeant(each, code)));
  const words = text.split(/[\s/]+/);
  const named = everyFunction.filter(({ name = '' }) =>
    words.every((word) =>
      name
        .toLowerCase()
        .split(/[\s/]+/)
        .some((own) => own.startsWith(word)),
    ),
  );
  const unnamed = codes
    .map((code) => ({ code, range: codeRange(code), texts: { functionCode: String(code) } }))
    .filter(({ code }) => partCodes === undefined && !everyFunction.some((each) => each.code === code));
  return [...new Set<FoundFunction>([...found, ...named, ...unnamed])].slice(0, MOST);
}

/** The codes that digits may be: as they are read anywhere on the page, then as the hexadecimal digits of a byte. */
function codesIn(text: string): readonly number[] {
  const asHex = /^[0-9a-f]{1,2}$/.test(text) ? Number.parseInt(text, 16) : undefined;
  const codes = [readNumber(text), asHex].filter((code) => code !== undefined);
  return [...new Set(codes)].filter((code) => Number.isInteger(code) && code >= 0 && code <= 0xff);
}
