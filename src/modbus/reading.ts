import { type Force, fieldsOf, type Seen, type Values } from './field.ts';
import { rawCoil } from './fields/bits.ts';
import type { FunctionCode } from './function-code.ts';
import type { Fault, Problem, Section } from './problem.ts';
import type { Span } from './span.ts';

/** How the bytes are carried. RTU over TCP is RTU. `pdu` is the function code and its data alone. */
export type Transport = 'rtu' | 'ascii' | 'tcp' | 'pdu';
export type Direction = 'request' | 'response';

/**
 * Whether the bytes are one frame: exactly; not yet, with the least number of bytes still to come; or with bytes left over
 * after it. What is wrong *inside* a whole frame is a problem, not an outcome.
 */
export type Outcome =
  | { readonly kind: 'whole' }
  | { readonly kind: 'short'; readonly missing: number }
  | { readonly kind: 'extra'; readonly bytes: number };

const NOTHING: Force = Object.freeze({});
const WHOLE: Outcome = Object.freeze({ kind: 'whole' });
const NONE: readonly Problem[] = Object.freeze([]);

/** Everything that a frame's bytes say. */
export class Reading implements Seen {
  readonly transport: Transport;
  readonly direction: Direction;
  outcome: Outcome = WHOLE;
  /** Absent if the bytes end before it, and in a bare PDU. */
  unitId: number | undefined = undefined;
  /** TCP only. */
  transactionId: number | undefined = undefined;
  /** With the exception bit, if it is set. */
  functionCode: number | undefined = undefined;
  readonly fields: Record<string, unknown> = {};
  /**
   * By field name, what the encoder would not have written by itself: numbers, or bytes verbatim (`''` for a field that is
   * cut off). `rest` is bytes inside the PDU that no field takes, `after` bytes after the frame.
   */
  forced: Force = NOTHING;
  /** Together they cover every byte exactly once, in order. */
  readonly spans: Span[] = [];
  problems: readonly Problem[] = NONE;
  request: Reading | undefined;
  /** The description the PDU was read by. */
  description: FunctionCode | undefined = undefined;
  /** Bytes that the byte count read last states, and items that the quantity of a list states. */
  count = 0;
  items = 0;
  /** No byte says where the PDU ends; it took all the bytes there were. */
  open = false;
  /** Of the envelope, as read: checksum, and the MBAP's protocol identifier and length. */
  checksum: number | undefined = undefined;
  protocolId: number | undefined = undefined;
  length: number | undefined = undefined;

  constructor(transport: Transport, direction: Direction, request: Reading | undefined) {
    this.transport = transport;
    this.direction = direction;
    this.request = request;
  }

  /** What the encoder works out, as the bytes have it: counts, lengths and the checksum by field name. */
  get derived(): Values {
    const derived: Record<string, unknown> = {};
    const put = (name: string, value: unknown) => {
      const had = this.forced[name] ?? value;
      if (typeof had === 'number') derived[name] = had;
    };
    put('protocolId', this.protocolId);
    put('length', this.length);
    for (const { field } of fieldsOf(this.description, this.direction, this.fields)) {
      if (field.derive) put(field.name, field.derive(this.fields));
      const value = this.fields[field.name];
      if (field.kind === 'flag' && value !== undefined) put('rawValue', rawCoil(value === true));
    }
    put('checksum', this.checksum);
    return derived;
  }

  force(name: string, value: number | string): void {
    this.forced = { ...this.forced, [name]: value };
  }

  /** Adds a problem; its section is the fault's own, or else the function's. */
  report(fault: Fault, span: Span, section?: Section): void {
    const at = fault.section ?? section ?? this.description?.section ?? 'AP 4.1';
    this.problems = [...this.problems, { ...fault, section: at, span } as Problem];
  }

  /** Forgets everything read so far, before the same bytes are read another way. */
  reset(): void {
    this.outcome = WHOLE;
    this.unitId = undefined;
    this.transactionId = undefined;
    this.functionCode = undefined;
    for (const name of Object.keys(this.fields)) delete this.fields[name];
    this.forced = NOTHING;
    this.spans.length = 0;
    this.problems = NONE;
    this.description = undefined;
    this.open = false;
    this.checksum = undefined;
  }
}

/** The value of a field, chosen or derived, by its name. */
export const fieldValue = ({ fields, derived }: { fields: Values; derived: Values }, name: string): unknown =>
  Object.hasOwn(fields, name) ? fields[name] : derived[name];
