import {
  hexDigits,
  isNumberType,
  type NumberTypeName,
  numberTypes,
  shortestFloat,
  type Value,
  type ValueType,
  writeValue,
} from '../../modbus/index.ts';

/**
 * A value as text that is read back as the same: whole numbers in decimal, floats as the shortest decimal, bits from the
 * highest in groups of four, text in double quotes with its own quotes doubled.
 */
export function formatValue(value: Value, type: ValueType): string {
  if (typeof value === 'string') return `"${value.replaceAll('"', '""')}"`;
  if (!isNumberType(type)) return String(value);
  const { kind, registers, least } = numberTypes[type];
  switch (kind) {
    case 'float':
      return shortestFloat(Number(value), type);
    case 'bits':
      return (
        BigInt(value)
          .toString(2)
          .padStart(16 * registers, '0')
          .match(/.{4}/g) ?? []
      ).join('_');
    case 'bcd':
      return least < 0 ? String(value) : String(value).padStart(4 * registers, '0');
    case 'integer':
      return String(value);
  }
}

/** The bits of a value in hexadecimal, high byte first, with `0x`: `0xFFFB` for −5 as i16. */
export function formatValueHex(value: number | bigint, type: NumberTypeName): string {
  const written = writeValue(value, type, 'ABCD');
  const registers = written.kind === 'registers' ? written.registers : [];
  return `0x${registers.map((register) => hexDigits(register, 4)).join('')}`;
}
