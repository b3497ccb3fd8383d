import type { Profile } from '../devices/index.ts';
import type { FrameInput, Reading, SerialLine, Transport } from '../modbus/index.ts';
import type { Code, Name, Parameter, Scalar, TableRow } from './code.ts';
import type { CrcWay, ProgramPart } from './options.ts';

/** A parameter of the routine that builds the request, with what it is in the current request: a list if it is an array. */
export interface BuildArgument {
  readonly parameter: Parameter;
  readonly value: number | readonly number[];
  /** Its values that a routine `(units) → word` makes of what is given in units: of an array by the index of the element. */
  readonly scaled?: readonly ScaledValue[] | undefined;
}

/** A value in units, and the routine that makes the register of it. `index` is 0 for a parameter that is no array. */
export interface ScaledValue {
  readonly index: number;
  readonly routine: Name;
  readonly value: number;
  readonly unit: string;
}

/** A value that a good reply gives. */
export interface ReplyValue {
  /** The routine that takes it out of the bytes of a checked reply, `(reply) → type`. */
  readonly routine: Name;
  readonly name: Name;
  readonly type: Scalar;
  readonly unit: string;
}

/** One request, and what belongs to it in `code`. */
export interface PlannedRequest {
  readonly name: Name;
  readonly input: FrameInput;
  readonly bytes: Uint8Array;
  readonly reading: Reading;
  /** What it does, in one line: `Write Single Register, unit 6: address 683 = 4096`. */
  readonly about: string;
  /** The table in `code` that holds its bytes; absent if it is built. */
  readonly table: Name | undefined;
  /** A line for each span of the bytes. */
  readonly rows: readonly TableRow[];
  /** The routine that builds it; absent if the part does not need it, or if it has only constant bytes. */
  readonly build: Name | undefined;
  readonly arguments: readonly BuildArgument[];
  /**
   * `(request, reply, reply length[, list]) → int`: 0 if the reply is good, the code of an exception, or one of the negative
   * constants of `code`. Absent if there is no reply: of a broadcast.
   */
  readonly check: Name | undefined;
  /** The list that `check` fills, if the reply has one: words of registers, truths of bits, or bytes. */
  readonly list: Parameter | undefined;
  /** Tells how many elements of the list a good reply fills, an `int`; absent if it fills all of them. */
  readonly items?: { readonly routine: Name; readonly takes: readonly ('reply' | 'reply length')[] } | undefined;
  /**
   * `(reply, reply length) → int`: the bytes that the whole reply has, or that must be there before more can be said; 0 if no
   * byte says where it ends, so that silence does.
   */
  readonly wanted: Name | undefined;
  readonly values: readonly ReplyValue[];
}

export interface PlannedSequence {
  readonly steps: readonly PlannedStep[];
  /** Carried out when the steps have ended, in whatever way; no failure ends it. */
  readonly finally: readonly PlannedStep[];
}

/** `stops`: its failure ends the steps. Times are in milliseconds. `about` says it in a line. */
export type PlannedStep = { readonly about: string } & (
  | { readonly kind: 'send'; readonly request: PlannedRequest; readonly stops: boolean }
  | { readonly kind: 'wait'; readonly duration: number }
  /** Reads again every `interval`, until the routine `holds`, `(reply) → bool`, says so of a good reply; it fails after `timeout`. */
  | {
      readonly kind: 'until';
      readonly request: PlannedRequest;
      readonly holds: Name;
      readonly interval: number;
      readonly timeout: number;
      readonly stops: boolean;
    }
  | { readonly kind: 'repeat'; readonly times: number; readonly steps: readonly PlannedStep[] }
);

/** Everything a target is to write. */
export interface Plan {
  readonly options: Settings;
  readonly transport: Transport;
  readonly requests: readonly PlannedRequest[];
  /** The requests that it sends, and reads with, are in `requests`. */
  readonly sequence: PlannedSequence | undefined;
  readonly code: Code;
}

/** The options with everything filled in. */
export interface Settings {
  readonly part: ProgramPart;
  readonly crc: CrcWay;
  readonly comments: boolean;
  readonly names: Readonly<Record<string, string>>;
  readonly units: boolean;
  readonly echo: boolean;
  readonly timeout: number;
  readonly name: string | undefined;
  readonly profile: Profile | undefined;
  readonly line: SerialLine & { readonly port: string };
  readonly server: { readonly host: string; readonly port: number };
}

/** Something a reader of the program should know. */
export interface ProgramNote {
  readonly code: string;
  readonly [data: string]: unknown;
}
