import { deviceUnit, readRequest } from '../../devices/index.ts';
import { decodeFrame, functionFor, hexDigits, readerOf } from '../../modbus/index.ts';
import { readNumbers } from '../../notation/index.ts';
import { withAddress } from '../frame/address-typed.ts';
import { type Draft, withText } from '../frame/draft.ts';
import { draftOf } from '../frame/draft-of-reading.ts';
import { evaluate } from '../frame/evaluate.ts';
import { targetsOf } from '../frame/form-layout.ts';
import { withTyped } from '../frame/typed.ts';
import { valueInFrame } from '../values/typed-values.ts';
import { addressingOf, type InputContext, type InputPlace } from './input-place.ts';

const ENVELOPE = ['unitId', 'transactionId'] as const;

/** A request on the transport, and to the unit, of the frame that is there. */
export function requestWith({ transport, texts }: Draft, more: Draft['texts']): Draft {
  const kept = ENVELOPE.flatMap((name) => (texts[name] === undefined ? [] : [[name, texts[name]]]));
  return { transport, kind: 'request', texts: { ...Object.fromEntries(kept), ...more }, force: {}, answering: '' };
}

/** To whom a request goes that a text asks for: the unit it says, or that a device has which is not chosen yet. */
function unitFor({ named }: InputPlace, { device, draft }: InputContext, unit: string | undefined): Draft['texts'] {
  const serial = draft.transport === 'rtu' || draft.transport === 'ascii';
  const theirs = serial && named && named.profile.id !== device?.id ? deviceUnit(named.profile) : undefined;
  const unitId = unit ?? theirs?.toString();
  return unitId === undefined ? {} : { unitId };
}

/** The request that reads from a place on; as many elements as are asked for, or as one value of the device has. */
export function readDraft(
  place: InputPlace,
  context: InputContext,
  { unit, quantity }: { readonly unit?: string | undefined; readonly quantity?: string | undefined } = {},
): Draft {
  const { table, typed, named, size = 1 } = place;
  const many = quantity ?? String(named ? readRequest(named.profile, named.register, 0).fields.quantity : size);
  const functionCode = String(readerOf(table).code);
  const base = requestWith(context.draft, { ...unitFor(place, context, unit), functionCode, quantity: many });
  const path = 'startAddress';
  return withAddress(base, { path, typed, table }, addressingOf(place, context), deviceOf(place, context));
}

/** What is typed for a register with a name is read by the device that has it. */
const deviceOf = ({ named }: InputPlace, { device }: InputContext): string | undefined =>
  named?.profile.id ?? device?.id;

/** The request that writes a value, as it was typed, to a place; `undefined` if nothing writes there. */
export function writeDraft(
  place: InputPlace,
  value: string,
  context: InputContext,
  asked: { readonly unit?: string | undefined; readonly items?: 'one' | 'many' | 'other' | undefined } = {},
): Draft | undefined {
  const { table, typed, named } = place;
  const units = { device: named?.profile ?? context.device, own: context.own };
  for (const items of ['one', 'many'] as const) {
    if (asked.items !== undefined && asked.items !== items) continue;
    const writer = functionFor(table, 'writes', items);
    if (writer === undefined) return undefined;
    const path = items === 'one' ? 'address' : 'startAddress';
    const base = requestWith(context.draft, {
      ...unitFor(place, context, asked.unit),
      functionCode: String(writer.code),
    });
    const id = deviceOf(place, context);
    const draft = withAddress(base, { path, typed, table }, addressingOf(place, context), id);
    const evaluation = evaluate(draft);
    const [control] = targetsOf(evaluation);
    if (control === undefined) return bitsDraft(draft, value, items);
    const text = valueInFrame(value, { control, draft, evaluation }, units);
    const next = withTyped(draft, control.path, value, text, id);
    // A value of two registers, or a list, needs the function that writes many.
    if (asked.items !== undefined || items === 'many' || !needsMany(value, context, place)) return next;
  }
  return undefined;
}

/** The function that writes single bits of a register (AP 6.16). */
const MASK_WRITE = 0x16;
const REGISTER = 0xffff;

/** The request that writes the bit of a place: `on` and `1`, or `off` and `0`; an empty value is left open. `undefined` for others. */
export function bitDraft(
  place: InputPlace,
  value: string,
  context: InputContext,
  unit: string | undefined,
): Draft | undefined {
  const { table, typed, bit = 0 } = place;
  if (functionFor(table, 'writes', 'one') === undefined || !/^(?:[01]|on|off|true|false)?$/i.test(value))
    return undefined;
  const mask = 1 << bit;
  const set = value === '' ? '' : `0x${hexDigits(/^(?:1|on|true)$/i.test(value) ? mask : 0, 4)}`;
  const base = requestWith(context.draft, {
    ...unitFor(place, context, unit),
    functionCode: String(MASK_WRITE),
    andMask: `0x${hexDigits(REGISTER - mask, 4)}`,
    orMask: set,
  });
  const to = { path: 'referenceAddress', typed, table };
  return withAddress(base, to, addressingOf(place, context), deviceOf(place, context));
}

/** Whether a value has more registers than one. */
function needsMany(value: string, context: InputContext, place: InputPlace): boolean {
  const many = functionFor(place.table, 'writes', 'many');
  if (many === undefined) return false;
  const list = readNumbers(value);
  if (list.kind === 'list') return list.items.length > 1 || registersOf(place) > 1;
  const base = requestWith(context.draft, { functionCode: String(many.code), startAddress: String(place.address) });
  const evaluation = evaluate(base);
  const [control] = targetsOf(evaluation);
  const units = { device: place.named?.profile ?? context.device, own: context.own };
  const text = control ? valueInFrame(value, { control, draft: base, evaluation }, units) : value;
  const registers = readNumbers(text);
  return registers.kind === 'list' && registers.items.length > 1;
}

const registersOf = ({ named }: InputPlace): number =>
  named ? readRequest(named.profile, named.register, 0).fields.quantity : 1;

/** Coils have no types: what is typed is 0 and 1, or on and off. */
function bitsDraft(draft: Draft, value: string, items: 'one' | 'many'): Draft {
  const bits = value.replace(/\b(?:on|true)\b/gi, '1').replace(/\b(?:off|false)\b/gi, '0');
  return withText(draft, items === 'one' ? 'value' : 'bits', bits);
}

/** Bytes as they are, though they are not a frame. */
export function bytesDraft(bytes: Uint8Array, { draft: { transport } }: InputContext): Draft {
  return draftOf(decodeFrame(bytes, { transport, direction: 'request' }), undefined);
}

/** Registers as a reply has them. */
export function valuesDraft(registers: readonly number[], { draft }: InputContext): Draft {
  const texts = {
    functionCode: String(readerOf('holding-register').code),
    registers: registers.map((register) => `0x${hexDigits(register, 4)}`).join(' '),
  };
  return { ...requestWith(draft, texts), kind: 'reply' };
}

/** The draft with a value for the register that it writes; `undefined` if it writes none. */
export function valueDraft(value: string, { draft, device, own }: InputContext): Draft | undefined {
  const evaluation = evaluate(draft);
  const [control] = targetsOf(evaluation);
  if (control === undefined) return undefined;
  const text = valueInFrame(value, { control, draft, evaluation }, { device, own });
  return withTyped(draft, control.path, value, text, device?.id);
}
