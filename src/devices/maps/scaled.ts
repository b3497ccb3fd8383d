import type { Register } from '../profile.ts';

/** What a foreign table says: value = raw × factor + offset. */
export interface FieldScale {
  readonly factor: number;
  readonly offset: number;
}

const tidy = (number: number): number => Number(number.toPrecision(14));

/** The scale of a register whose number is value × factor + offset. */
export const scaleOfRegister = ({ factor, offset }: FieldScale): Pick<Register, 'factor' | 'offset'> => ({
  factor: tidy(1 / factor),
  offset: offset === 0 ? 0 : tidy(-offset / factor),
});
