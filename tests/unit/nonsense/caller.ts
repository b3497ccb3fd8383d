import { writeSync } from 'node:fs';
import { inspect } from 'node:util';
import * as library from '../../../src/framewright.ts';
import * as sequences from '../../../src/sequences/index.ts';
import * as store from '../../../src/store/index.ts';
import * as workbench from '../../../src/workbench/index.ts';
import { Arguments } from './arguments.ts';
import { Chance } from './chance.ts';
import type { Complaint, Order, Said } from './order.ts';
import { parametersOf } from './parameters.ts';

/**
 * Calls every exported function with arguments that fit, that fit almost, and that make no sense. What functions answer
 * becomes an argument of others, so that none needs an example of its own. The calls of a function depend on its name and
 * the seed, so that another function shifts none of them.
 */
const { calls, seed, explain }: Order = JSON.parse(process.argv[2] ?? '');
/** Milliseconds of the processor. */
const MOST_FOR_A_CALL = 1000;

type Callable = (...args: unknown[]) => unknown;

const exported = Object.entries({ library, sequences, workbench, store }).flatMap(([layer, all]) =>
  Object.entries(all).map(([name, value]) => [`${layer}.${name}`, value as unknown] as const),
);
const functions = exported.flatMap(([name, value]) =>
  typeof value === 'function' ? [functionOf(name, value as Callable)] : [],
);
const pool = new Arguments();
for (const [name, value] of exported) if (typeof value !== 'function') pool.keep(name, value);

function functionOf(name: string, make: Callable) {
  const isClass = /^class\b/.test(Function.prototype.toString.call(make));
  const [, subject = ''] = /\.(?:[a-z]+(?=[A-Z]))?(\w+?)(?:Of)?$/.exec(name) ?? [];
  return {
    name,
    isClass,
    make,
    parameters: parametersOf(make, isClass),
    chance: new Chance(`${seed} ${name}`),
    /** What it answers, if it is called as most are: `sceneOf` and `readScene` answer a scene. */
    subject: subject.charAt(0).toLowerCase() + subject.slice(1),
  };
}

/** The answer; of what is still to be worked out, the beginning. */
function answerOf(make: Callable, isClass: boolean, args: readonly unknown[], chance: Chance): unknown {
  const answer: unknown = isClass ? Reflect.construct(make, args) : make(...args);
  if (typeof answer === 'function') {
    const isBuiltIn = Function.prototype.toString.call(answer).includes('[native code]');
    return isBuiltIn ? undefined : answer(pool.take(chance));
  }
  if (typeof answer !== 'object' || answer === null || !(Symbol.iterator in answer) || !('next' in answer))
    return answer;
  const found: unknown[] = [];
  for (const one of answer as object as Iterable<unknown>) if (found.push(one) === 100) break;
  return found;
}

const isTyped = (error: unknown): boolean =>
  error instanceof library.FrameError ||
  error instanceof TypeError ||
  (error instanceof RangeError && !/call stack/.test(error.message));

/** Waits until it is written: what follows may never end. */
const say = (what: Said) => writeSync(1, `${JSON.stringify(what)}\n`);

const complaints = new Map<string, Complaint>();
let number = 0;
for (let round = 0; round < calls; round++) {
  for (const { name, make, isClass, parameters, subject, chance } of functions) {
    const args = pool.takeAll(parameters, chance);
    const call = () =>
      `${name}(${args.map((one) => inspect(one, { breakLength: Infinity, maxStringLength: 100 }).slice(0, 400)).join(', ')})`;
    const complain = (why: string) => complaints.has(name) || complaints.set(name, { call: call(), why });
    if (number === explain) say(call());
    say(number++);
    const begun = process.cpuUsage();
    try {
      const answer = answerOf(make, isClass, args, chance);
      pool.keep(`${name} ${chance.below(10)}`, answer);
      pool.learn(subject, answer, chance);
      parameters.forEach((one, index) => {
        if (one.kind === 'name') pool.learn(one.name, args[index], chance);
        else for (const [key] of one.fields) pool.learn(key, Object(args[index])[key], chance);
      });
    } catch (error) {
      if (!isTyped(error)) complain(inspect(error));
    }
    const { user, system } = process.cpuUsage(begun);
    const took = (user + system) / 1000;
    if (took > MOST_FOR_A_CALL) complain(`it takes ${took.toFixed()} ms`);
  }
}
say({ functions: functions.map(({ name }) => name), complaints: [...complaints.values()] });
