import {
  canRead,
  canWrite,
  type Profile,
  type Register,
  type RegisterRequest,
  readRequest,
  writeRequest,
} from '../../devices/index.ts';
import { counterpart, describeFunction, quantityOf, writesAt } from '../../modbus/index.ts';
import { readBits, readNumbers } from '../../notation/index.ts';
import { type Draft, withForce, withText } from '../frame/draft.ts';
import type { Control, Evaluation } from '../frame/evaluate.ts';

/** A field that takes an address, in the frame that is edited. */
export interface AddressField {
  readonly draft: Draft;
  readonly evaluation: Evaluation;
  readonly path: string;
}

/** What writes zero into the first value of a line: a whole line is read at once, but not overwritten. */
const writeFirst = (profile: Profile, register: Register) => writeRequest(profile, register, 0);

/** The function that a register is picked with: that of the frame if it fits; `undefined` if a reply cannot have the register. */
export function functionFor(
  { draft, evaluation, path }: AddressField,
  profile: Profile,
  register: Register,
): number | undefined {
  const { code, table, items } = evaluation.description;
  if (draft.kind !== 'request') return register.table === table ? code : undefined;
  const writes = writesAt(evaluation.description, path);
  const fits = writes ? canWrite(register) : canRead(register);
  const { functionCode } = (writes === fits ? writeFirst : readRequest)(profile, register);
  const takesMany = describeFunction(functionCode, 'request').items === 'many';
  if (!fits || (items === 'one' && takesMany)) return functionCode;
  return register.table === table ? code : (counterpart(code, register.table)?.code ?? functionCode);
}

/** The draft with a register's address in a field, and with as many items as the register has. */
export function picked(field: AddressField, profile: Profile, register: Register): Draft {
  const { draft, evaluation, path } = field;
  const { code } = evaluation.description;
  const wanted = functionFor(field, profile, register) ?? code;
  const address = String(register.address);
  if (wanted === code) return withItems(field, withText(draft, path, address), profile, register);
  if (wanted === counterpart(code, register.table)?.code)
    return withItems(
      field,
      withText(withText(draft, path, address), 'functionCode', String(wanted)),
      profile,
      register,
    );
  const read = readRequest(profile, register);
  return requestDraft(draft, read.functionCode === wanted ? read : writeFirst(profile, register));
}

/** The draft with the quantity for an address, or with a list of that length. */
function withItems({ draft, evaluation, path }: AddressField, next: Draft, profile: Profile, register: Register) {
  const quantity = evaluation.controls.find((control) => control.path === quantityOf(path));
  if (draft.kind !== 'request' || quantity === undefined) return next;
  if (!quantity.derived) return withText(next, quantity.path, String(readRequest(profile, register).fields.quantity));
  const { fields, force } = writeFirst(profile, register);
  const zeros = [fields['registers'] ?? fields['bits'] ?? 0].flat();
  const list = evaluation.controls.find(({ field }) => field.kind === 'registers' || field.kind === 'bits');
  const forced = withForce(next, quantity.path, force['quantity']?.toString());
  return list === undefined || lengthOf(list) === zeros.length ? forced : withText(forced, list.path, zeros.join(' '));
}

function lengthOf({ field, text }: Control): number | undefined {
  const list = field.kind === 'bits' ? readBits(text) : readNumbers(text);
  return list.kind === 'list' ? list.items.length : undefined;
}

/** The draft of a request; what the request does not say stays as it was. */
export const requestDraft = ({ transport, texts }: Draft, { functionCode, fields, force }: RegisterRequest): Draft => ({
  transport,
  kind: 'request',
  texts: { ...texts, functionCode: String(functionCode), ...textsOf(fields) },
  force: textsOf(force),
  answering: '',
});

/** The draft of a request to a device; on a serial line it is for the unit that the device has. */
export function deviceRequest(draft: Draft, request: RegisterRequest, of: number | undefined): Draft {
  const { transport } = draft;
  const unit = transport === 'rtu' || transport === 'ascii' ? of : undefined;
  const next = requestDraft(draft, request);
  return unit === undefined ? next : withText(next, 'unitId', String(unit));
}

/** The draft with one byte of bits more than the specification counts: `count` of them. */
export const withByteCount = (draft: Draft, count: number): Draft => ({
  ...draft,
  force: { ...draft.force, byteCount: String(count), rest: '00' },
  bytes: undefined,
});

const textsOf = (values: Readonly<Record<string, number | readonly number[]>>): Record<string, string> =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, typeof value === 'number' ? String(value) : value.join(' ')]),
  );
