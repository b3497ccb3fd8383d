import { linesBehind, type NamedNumber } from '../../../../devices/index.ts';
import type { BitEffect } from '../../../../modbus/index.ts';
import { Select } from '../../../kit/choice.tsx';
import { device } from '../../device/naming.ts';
import { useWords } from '../../words.ts';

/** What a mask write can do to a bit, in the order it is offered. */
export const EFFECTS = ['keep', 'set', 'clear'] as const satisfies readonly BitEffect[];

/** The bits of a holding register that the device chosen has names for. */
export function namedBits(address: unknown): readonly NamedNumber[] {
  const profile = device.value;
  if (profile === undefined || typeof address !== 'number') return [];
  return linesBehind(profile, 'holding-register', address, 0).flatMap(({ type, names }) =>
    type === 'bits' ? names : [],
  );
}

interface BitsProps {
  readonly bits: readonly NamedNumber[];
  /** What the masks do to each bit, bit 0 first. */
  readonly effects: readonly BitEffect[];
  readonly onChoose: (bit: number, effect: BitEffect) => void;
}

/** The device's bits by name, each kept, set or cleared. */
export function NamedBits({ bits, effects, onChoose }: BitsProps) {
  const words = useWords('values');
  if (bits.length === 0) return null;
  return (
    <fieldset class="named-bits field-grid">
      <legend>{words.namedBits}</legend>
      {bits.map(({ number, name }) => (
        <label key={number}>
          <Select
            value={effects[number] ?? EFFECTS[0]}
            options={EFFECTS.map((value) => ({ value, name: words.doing[value] }))}
            onChoose={(effect) => onChoose(number, effect)}
          />{' '}
          {words.namedBit(number, name)}
        </label>
      ))}
    </fieldset>
  );
}

/** The names of the bits that are 1 in a register, of those that have a name. */
export const namesIn = (bits: readonly NamedNumber[], register: number): string =>
  bits
    .filter(({ number }) => ((register >>> number) & 1) === 1)
    .map(({ name }) => name)
    .join(', ');
