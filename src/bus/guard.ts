import { BROADCAST, type Reading } from '../modbus/index.ts';

/** Functions that change nothing in a device (AP 6). Any other may, and codes that nobody has described are any other. */
const READING_FUNCTIONS: ReadonlySet<number> = new Set([0x01, 0x02, 0x03, 0x04, 0x07, 0x0b, 0x0c, 0x11, 0x14, 0x18]);
/** Sub-functions of Diagnostics that only answer (AP 6.8.1): the rest restart, silence or clear something. */
const READING_SUB_FUNCTIONS: ReadonlySet<unknown> = new Set([
  0x00, 0x02, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12,
]);
const DIAGNOSTICS = 0x08;
const ENCAPSULATED = 0x2b;
/** The MEI type that reads identification (AP 6.21); CANopen's can do anything. */
const READ_IDENTIFICATION = 0x0e;

/** Whether a request may change something in a device. */
export function mayChange({ functionCode, fields }: Reading): boolean {
  if (functionCode === DIAGNOSTICS) return !READING_SUB_FUNCTIONS.has(fields['subFunction']);
  if (functionCode === ENCAPSULATED) return fields['meiType'] !== READ_IDENTIFICATION;
  return functionCode === undefined || !READING_FUNCTIONS.has(functionCode);
}

/** Why somebody is asked before a request is sent. */
export type Doubt =
  /** The first request of this session that may change something in this device. */
  | 'first-write'
  /** Every device on the line obeys, and none answers. */
  | 'broadcast'
  /** It is against the specification: what a device makes of it is not known. */
  | 'breaks-rule';

/**
 * `serving`: the virtual devices answer on this line, where somebody else asks. `listening` and `scanning`: a job has the
 * line to itself. `busy`: it is to have that, and something else is being sent.
 */
export type Refusal = 'read-only' | 'serving' | 'listening' | 'scanning' | 'busy';

export type Permission =
  | { readonly kind: 'free' }
  /** `once` holds for the device and the session, the others for this request. */
  | { readonly kind: 'ask'; readonly why: Doubt; readonly once: boolean }
  | { readonly kind: 'refused'; readonly why: Refusal };

export interface GuardState {
  /** Nothing that may change a device is sent. */
  readonly readOnly: boolean;
  /** The units that may be written to, as somebody has said. */
  readonly writable: ReadonlySet<number>;
}

/** Whether a request may be sent, or somebody is to be asked first. */
export function permissionFor(reading: Reading, guard: GuardState): Permission {
  const { unitId, outcome, problems } = reading;
  const changes = mayChange(reading);
  if (changes && guard.readOnly) return { kind: 'refused', why: 'read-only' };
  if (outcome.kind !== 'whole' || problems.some(({ severity }) => severity === 'error')) {
    return { kind: 'ask', why: 'breaks-rule', once: false };
  }
  if (!changes) return { kind: 'free' };
  if (unitId === BROADCAST) return { kind: 'ask', why: 'broadcast', once: false };
  if (unitId !== undefined && guard.writable.has(unitId)) return { kind: 'free' };
  return { kind: 'ask', why: 'first-write', once: true };
}
