import type { RegisterRequest, SerialSettings } from '../../devices/index.ts';
import { requestDraft, withText } from '../../workbench/index.ts';
import { takeUp } from '../examples/at-hand.ts';
import { draft } from '../state.ts';

/** Makes the request for a register the frame at hand, for the unit that the device has of itself. */
export function takeRequest(request: RegisterRequest, serial: SerialSettings | undefined): void {
  const { transport } = draft.value;
  const unit = transport === 'rtu' || transport === 'ascii' ? serial?.unit : undefined;
  const next = requestDraft(draft.value, request);
  takeUp(unit === undefined ? next : withText(next, 'unitId', String(unit)));
}

/** The frame with one byte of bits more than the specification counts. */
export function takeByteCount(count: number): void {
  const { value } = draft;
  takeUp({ ...value, force: { ...value.force, byteCount: String(count), rest: '00' }, bytes: undefined });
}
