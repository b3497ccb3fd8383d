import { firstAddress, partsOf, type Reading, type Table } from '../../modbus/index.ts';

/** The bits of one byte of a frame, the lowest address first. */
export interface BitRow {
  /** Zero-based address of the first, or its place in the list if no address is known. */
  readonly first: number;
  /** The table of the addresses; `undefined` if `first` is no address. */
  readonly table: Table | undefined;
  readonly bits: readonly number[];
  readonly byte: number;
  readonly from: number;
  readonly to: number;
}

/** The coils or inputs of a frame, a row for each byte that carries them; unused bits are left out. */
export const bitsByByte = (reading: Reading, bytes: Uint8Array): BitRow[] =>
  reading.spans
    .filter(({ kind }) => kind === 'bits')
    .flatMap((span) => {
      const first = firstAddress(reading, span.name);
      const table = first === undefined ? undefined : reading.description?.table;
      return partsOf(reading, bytes, span).map(({ index, span: { from, to }, values }) => {
        const bits = values['value'] as readonly number[];
        const byte = bits.reduce((sum, bit, at) => sum | (bit << at), 0);
        return { first: (first ?? 0) + 8 * index, table, bits, byte, from, to };
      });
    });
