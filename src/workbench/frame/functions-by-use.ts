import { type CodeRange, diagnosticSubFunctions, functionCodes, meiTypes } from '../../modbus/index.ts';

/** A function, sub-function or MEI type, or a code without a name, and the texts of a draft that choose it. */
export interface FoundFunction {
  readonly code: number;
  /** The sub-function or MEI type, if it is one of a function that has several. */
  readonly part?: number;
  /** Its name in the specification; `undefined` for a code without a description. */
  readonly name?: string;
  /** Of a code without a name: who it is for. */
  readonly range?: CodeRange;
  readonly serialOnly?: boolean;
  readonly texts: Readonly<Record<string, string>>;
}

/** Codes and parts of codes in the order of their use, the most used first. What is not here follows by its number. */
const BY_USE = [3, 6, 16, 4, 1, 5, 15, 2, 23, 22, '43/14', 8, 17];

/** The function whose codes are MEI types. */
const MEI = 0x2b;

const rankOf = ({ code, part }: FoundFunction): number => {
  const rank = BY_USE.findIndex((each) => each === code || each === `${code}/${part}`);
  return rank < 0 ? BY_USE.length : rank;
};

const functions: readonly FoundFunction[] = functionCodes.map((description) => ({
  code: description.code,
  name: description.name,
  serialOnly: 'serialOnly' in description,
  texts: { functionCode: String(description.code) },
}));

const parts: readonly FoundFunction[] = [
  ...meiTypes.map(({ meiType, name }) => ({
    code: MEI,
    part: meiType,
    name,
    texts: { functionCode: String(MEI), meiType: String(meiType) },
  })),
  ...diagnosticSubFunctions.map(({ code, name }) => ({
    code: 0x08,
    part: code,
    name,
    texts: { functionCode: '8', subFunction: String(code) },
  })),
];

/** Those with a rank first, then by number; of one number the function before its parts. */
const byUse = (found: readonly FoundFunction[]) =>
  found.toSorted((a, b) => rankOf(a) - rankOf(b) || a.code - b.code || (a.part ?? -1) - (b.part ?? -1));

const isMei = ({ code }: FoundFunction) => code === MEI;

/** Every public function in the order of its use; 43 by its MEI types, of which Read Device Identification comes first. */
export const functionsByUse: readonly FoundFunction[] = byUse([
  ...functions.filter((each) => !isMei(each)),
  ...parts.filter(isMei),
]);

/** Every public function, sub-function and MEI type in the order of its use; of one number the function before its parts. */
export const everyFunction: readonly FoundFunction[] = byUse([...functions.filter((each) => !isMei(each)), ...parts]);

/** The function that a code and, of 43, a MEI type stand for; `undefined` for a code without a description. */
export const functionWith = (code: number | undefined, meiType: number | undefined): FoundFunction | undefined =>
  functionsByUse.find((each) => each.code === code && (each.part === undefined || each.part === meiType)) ??
  functions.find((each) => each.code === code);

/** The values of a field in the order of their use: of the MEI types the used one first. */
export const valuesByUse = (field: string, values: readonly number[]): readonly number[] =>
  field === 'meiType'
    ? byUse(parts.filter(isMei)).flatMap(({ part }) => values.filter((each) => each === part))
    : values;
