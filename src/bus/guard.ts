import { accessOf, BROADCAST, type FunctionCode, functionCodes, type Reading } from '../modbus/index.ts';

/** Whether a request may change something in a device. A request that nobody has described may. */
export const mayChange = (reading: Reading): boolean => accessOf(reading) !== 'reads';

const codesWhere = (test: (description: FunctionCode) => boolean): readonly number[] =>
  functionCodes.filter(test).map(({ code }) => code);

/** The functions that are sent while only reading is allowed: those of which every request reads, and those of which some do. */
export const readOnlyCodes = {
  all: codesWhere(({ access }) => access === 'reads'),
  some: codesWhere(({ access }) => typeof access === 'object'),
};

/** Why somebody is asked before a request is sent. */
export type Doubt =
  /** The first request of this session that may change something in this device. */
  | 'first-write'
  /** Every device on the line obeys, and no device answers. */
  | 'broadcast'
  /** It breaks a rule of the specification: what a device does with it is not known. */
  | 'breaks-rule';

/**
 * `serving`: the virtual devices answer on this line, and somebody else asks. `listening` and `scanning`: a job has the
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
  const { unitId, problems } = reading;
  const changes = mayChange(reading);
  if (changes && guard.readOnly) return { kind: 'refused', why: 'read-only' };
  // What is too short or too long has such a problem as well.
  if (problems.some(({ severity }) => severity === 'error')) {
    return { kind: 'ask', why: 'breaks-rule', once: false };
  }
  if (!changes) return { kind: 'free' };
  if (unitId === BROADCAST) return { kind: 'ask', why: 'broadcast', once: false };
  if (unitId !== undefined && guard.writable.has(unitId)) return { kind: 'free' };
  return { kind: 'ask', why: 'first-write', once: true };
}
