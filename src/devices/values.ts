import type { Value } from '../modbus/index.ts';
import type { NamedNumber, Register } from './profile.ts';

/** The value of a raw number in the unit of its line; `raw` itself if the line has no scale. */
export function inUnits(raw: number | bigint, { factor, offset }: Register): number | bigint {
  return factor === 1 && offset === 0 ? raw : (Number(raw) - offset) / factor;
}

/** The names of the bits that are 1, or the name of the value. */
export function namesOf(raw: Value, { type, names }: Register): readonly string[] {
  const holds = ({ number }: NamedNumber) =>
    type === 'bits' ? ((Number(raw) >>> number) & 1) === 1 : number === Number(raw);
  return typeof raw === 'string' ? [] : names.filter(holds).map(({ name }) => name);
}
