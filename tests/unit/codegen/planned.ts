import { makePlan } from '../../../src/codegen/make-plan.ts';
import type { ProgramOptions } from '../../../src/codegen/options.ts';
import type { BuildArgument, PlannedRequest, ProgramNote } from '../../../src/codegen/plan.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import type { FrameInput } from '../../../src/modbus/index.ts';
import { CodeRunner, type Given } from './run-code.ts';

/** A request that is planned, and what runs its routines. */
export class Planned {
  readonly request: PlannedRequest;
  readonly notes: readonly ProgramNote[];
  readonly #runner: CodeRunner;

  constructor(input: FrameInput, options: ProgramOptions = {}) {
    const { plan, notes } = makePlan([{ name: options.name, request: input }], settingsOf(options));
    this.request = plan.requests[0] as PlannedRequest;
    this.notes = notes;
    this.#runner = new CodeRunner(plan.code);
  }

  /** The bytes that the program sends: built from the arguments of now, or constant. */
  built(): readonly number[] {
    const { build, arguments: given, bytes } = this.request;
    return build === undefined ? [...bytes] : (this.#runner.run(build, ...given.map(givenAs)) as number[]);
  }

  /** What the check answers, and what it fills the list with. */
  checked(reply: Uint8Array): { readonly result: number; readonly list: readonly number[] | undefined } {
    const { check, list, bytes } = this.request;
    if (check === undefined) throw new Error('no check');
    const filled = list && new Array<number | boolean>(list.size ?? 0).fill(list.type === 'bool' ? false : 0);
    const result = this.#runner.run(
      check,
      [...bytes],
      [...reply],
      reply.length,
      ...(filled === undefined ? [] : [filled]),
    );
    return { result: result as number, list: filled?.map(Number) };
  }

  /** What `wanted` answers when so many bytes of the reply have come. */
  wanted(reply: Uint8Array, length: number): number {
    const { wanted } = this.request;
    if (wanted === undefined) throw new Error('no wanted');
    return this.#runner.run(wanted, [...reply.subarray(0, length)], length) as number;
  }

  /** A routine by its name. */
  run(routine: string, ...given: readonly Given[]): number[] | number | boolean {
    return this.#runner.run(routine, ...given);
  }
}

const givenAs = ({ parameter: { type }, value }: BuildArgument): Given => {
  const one = (number: number) => (type === 'bool' ? number === 1 : number);
  return typeof value === 'number' ? one(value) : value.map(one);
};
