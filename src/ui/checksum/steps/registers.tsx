import type { RegisterForm } from '../../../modbus/index.ts';
import { formatBinary } from '../../../notation/index.ts';

interface BitsProps {
  readonly form: RegisterForm;
  readonly value: number;
  /** Whether the bit that leaves next is marked. */
  readonly leaving?: boolean;
}

/** A register in binary. */
export function Bits({ form: { bits, reflected }, value, leaving = false }: BitsProps) {
  const text = formatBinary(value, bits);
  if (!leaving) return <span class="bits">{text}</span>;
  return reflected ? (
    <span class="bits">
      {text.slice(0, -1)}
      <b>{text.slice(-1)}</b>
    </span>
  ) : (
    <span class="bits">
      <b>{text.slice(0, 1)}</b>
      {text.slice(1)}
    </span>
  );
}
