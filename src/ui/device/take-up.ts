import type { RegisterRequest, SerialSettings } from '../../devices/index.ts';
import { takeUp } from '../examples/at-hand.ts';
import { draft } from '../state.ts';

/** Makes the request for a register the frame at hand, for the unit that the device has of itself. */
export function takeRequest(
  { functionCode, fields, force }: RegisterRequest,
  serial: SerialSettings | undefined,
): void {
  const { transport, texts } = draft.value;
  const unit = serial?.unit !== undefined && (transport === 'rtu' || transport === 'ascii') ? serial.unit : undefined;
  takeUp({
    transport,
    kind: 'request',
    texts: {
      ...texts,
      ...(unit === undefined ? {} : { unitId: String(unit) }),
      functionCode: String(functionCode),
      ...textsOf(fields),
    },
    force: textsOf(force),
    answering: '',
  });
}

/** The frame with one byte of bits more than the specification counts. */
export function takeByteCount(count: number): void {
  const { value } = draft;
  takeUp({ ...value, force: { ...value.force, byteCount: String(count), rest: '00' }, bytes: undefined });
}

const textsOf = (values: Readonly<Record<string, number | readonly number[]>>): Record<string, string> =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, typeof value === 'number' ? String(value) : value.join(' ')]),
  );
