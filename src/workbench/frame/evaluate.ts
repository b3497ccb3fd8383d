import {
  type Direction,
  decodeFrame,
  describeFunction,
  encodeFrame,
  type Field,
  type Force,
  FrameError,
  type FunctionCode,
  fieldsOf,
  fromHex,
  type Range,
  type Reading,
  type Section,
} from '../../modbus/index.ts';
import { readBits, readNumber, readNumbers, readOctets, unitOf, zeroBasedAddress } from '../../notation/index.ts';
import { type Draft, headerText, textOf } from './draft.ts';
import { forcedBytes } from './forced.ts';
import type { InputError } from './input-error.ts';

/** One field of the form. */
export interface Control {
  readonly path: string;
  readonly field: Field;
  readonly text: string;
  readonly section: Section;
  /** Whether the encoder works it out unless it is forced. */
  readonly derived: boolean;
  /** For groups: the controls of each. */
  readonly groups: readonly (readonly Control[])[];
}

/** The result of a draft: a frame, or why there is no frame. */
export interface Evaluation {
  readonly controls: readonly Control[];
  /** What is wrong with a text, by the path of its field. */
  readonly errors: ReadonlyMap<string, InputError>;
  readonly description: FunctionCode;
  readonly frame: { readonly bytes: Uint8Array; readonly reading: Reading } | undefined;
}

type Read<T = unknown> = { readonly value: T } | { readonly wrong: InputError };

/** Works out everything that follows from what was typed. */
export function evaluate(draft: Draft): Evaluation {
  const errors = new Map<string, InputError>();
  const direction: Direction = draft.kind === 'request' ? 'request' : 'response';
  const number = (name: Parameters<typeof headerText>[1], most: number) =>
    Object.hasOwn(draft.force, name)
      ? undefined
      : readInto(errors, name, readWhole(headerText(draft, name), name, most));
  const unitId = draft.transport === 'pdu' ? undefined : number('unitId', 0xff);
  const transactionId = draft.transport === 'tcp' ? number('transactionId', 0xffff) : undefined;
  const typedCode = number('functionCode', draft.kind === 'exception' ? 0x7f : 0xff);
  const shownCode = draft.kind === 'exception' ? 0x80 | (typedCode ?? 0) : (typedCode ?? 0);
  const description = describeFunction(shownCode, direction);
  // A frame that is cut off before its function code has no fields.
  const functionCode = Object.hasOwn(draft.force, 'functionCode') ? undefined : shownCode;

  const fields: Record<string, unknown> = {};
  const controls: Control[] = [];
  const laidOut = functionCode === undefined ? undefined : description;
  for (const { field, section } of fieldsOf(laidOut, direction, fields)) {
    const control = controlOf(draft, field, field.name, section);
    controls.push(control);
    if (!control.derived && !Object.hasOwn(draft.force, control.path))
      fields[field.name] = readControl(control, errors);
  }
  const force = readForce(draft, errors);
  if (draft.bytes !== undefined) errors.set('bytes', { code: 'not-octets', text: draft.bytes });
  const request = direction === 'response' ? readRequest(draft, errors) : undefined;
  if (errors.size > 0) return { controls, errors, description, frame: undefined };
  try {
    const input = { transport: draft.transport, direction, unitId, transactionId, functionCode, fields, force };
    const bytes = encodeFrame(input);
    const reading = decodeFrame(bytes, { transport: draft.transport, direction, request });
    return { controls, errors, description, frame: { bytes, reading } };
  } catch (error) {
    if (!(error instanceof FrameError)) throw error;
    errors.set(error.field, explain(error));
    return { controls, errors, description, frame: undefined };
  }
}

function controlOf(draft: Draft, field: Field, path: string, section: Section): Control {
  const derived = field.derive !== undefined;
  const text = derived ? (draft.force[path] ?? '') : textOf(draft, path, field);
  const count = field.kind === 'groups' ? Math.min(readNumber(text) ?? 0, 255) : 0;
  const groups = Array.from({ length: count }, (_, index) =>
    (field.group ?? [])
      .filter(({ derive }) => derive === undefined)
      .map((inner) => controlOf(draft, inner, `${path}[${index}].${inner.name}`, section)),
  );
  return { path, field, text, section, derived, groups };
}

/** The value of a control; if its text has no value, the reason goes to `errors`. */
function readControl(control: Control, errors: Map<string, InputError>): unknown {
  const { field, path } = control;
  if (field.kind === 'groups') {
    return control.groups.map((group) =>
      Object.fromEntries(group.map((inner) => [inner.field.name, readControl(inner, errors)])),
    );
  }
  return readInto(errors, path, readText(control));
}

function readInto<T>(errors: Map<string, InputError>, path: string, read: Read<T>): T | undefined {
  if ('value' in read) return read.value;
  errors.set(path, read.wrong);
  return undefined;
}

function readText({ field, path, text }: Control): Read {
  if (text.trim() === '' && field.width > 0) return { wrong: { code: 'field-missing' } };
  const unit = field.kind === 'registers' || field.name === 'value' ? unitOf(text) : undefined;
  if (unit !== undefined) return { wrong: { code: 'unit-without-device', text: text.trim(), unit } };
  switch (field.kind) {
    case 'registers':
    case 'list':
    case 'bits': {
      const list = field.kind === 'bits' ? readBits(text) : readNumbers(text);
      if (list.kind === 'list') return accepted(field, list.items, path);
      const code = field.kind === 'bits' ? 'not-a-bit' : 'not-a-number';
      return { wrong: { code, text: list.word.text, index: list.index } };
    }
    case 'bytes': {
      const octets = readOctets(text);
      return octets === undefined ? { wrong: { code: 'not-octets', text } } : { value: octets };
    }
    case 'flag':
      return accepted(field, readNumber(text), path);
    case 'address':
      return readWhole(text, path, 0xffff, zeroBasedAddress(text), 'not-an-address');
    default:
      return field.width === 1 ? readWhole(text, path, 0xff) : readWhole(text, path, 0xffff);
  }
}

function accepted(field: Field, value: unknown, path: string): Read {
  try {
    return { value: field.accept(value, path) };
  } catch (error) {
    if (error instanceof FrameError) return { wrong: explain(error) };
    throw error;
  }
}

function readWhole(
  text: string,
  path: string,
  most: number,
  got = readNumber(text),
  code: 'not-a-number' | 'not-an-address' = 'not-a-number',
): Read<number> {
  if (text.trim() === '') return { wrong: { code: 'field-missing' } };
  if (got === undefined) return { wrong: { code, text } };
  if (Number.isInteger(got) && got >= 0 && got <= most) return { value: got };
  return { wrong: explain(new FrameError(path, { code: 'number-out-of-range', got, least: 0, most })) };
}

/** Why an input has no bytes; an item of a list is named. */
function explain({ field, reason }: FrameError): InputError {
  const index = /\[(\d+)\]$/.exec(field)?.[1];
  return index === undefined ? reason : { ...reason, index: Number(index) };
}

/** Forced values: numbers, or hexadecimal pairs in brackets for bytes verbatim; some names take nothing but pairs. */
function readForce(draft: Draft, errors: Map<string, InputError>): Force {
  const force: Record<string, number | string> = Object.create(null);
  for (const [name, text] of Object.entries(draft.force)) {
    const pairs = forcedBytes.has(name) ? text : /^\s*\[([^\]]*)\]\s*$/.exec(text)?.[1];
    if (pairs !== undefined) {
      const octets = readOctets(pairs);
      if (octets === undefined) errors.set(name, { code: 'not-octets', text });
      else force[name] = octets;
    } else {
      const value = readInto(errors, name, readWhole(text, name, 0xffff));
      if (value !== undefined) force[name] = value;
    }
  }
  return force;
}

function readRequest(draft: Draft, errors: Map<string, InputError>): Uint8Array | undefined {
  const request = requestOf(draft);
  if (request === undefined && draft.answering.trim() !== '') {
    errors.set('answering', { code: 'not-octets', text: draft.answering });
  }
  return request;
}

/** The request that a reply is said to answer; `undefined` for a request, and if the text is not bytes. */
export function requestOf({ kind, answering }: Draft): Uint8Array | undefined {
  const octets = kind === 'request' || answering.trim() === '' ? undefined : readOctets(answering);
  return octets === undefined ? undefined : fromHex(octets);
}

/** What a number field may hold: the rule's range, or else all that fits. */
export const rangeOf = ({ range, width }: Field): Pick<Range, 'least' | 'most'> =>
  range ?? { least: 0, most: width === 1 ? 0xff : 0xffff };
