import { plainWords } from '../notation/index.ts';
import type { Code, Name, Routine } from './code.ts';
import { fresh } from './plain-words.ts';
import type { Plan, PlannedRequest, PlannedStep } from './plan.ts';

/** What a routine does, whatever it is called and said of it. */
const essence = ({ parameters, gives, body }: Routine): string =>
  JSON.stringify({ parameters, gives, body }, (key, value: unknown) => (key === 'comment' ? undefined : value));

/** Gives calls the names that routines have now. */
const withCalls = (routine: Routine, names: ReadonlyMap<Name, Name>): Routine =>
  names.size === 0
    ? routine
    : (JSON.parse(JSON.stringify(routine), (key, value: unknown) =>
        key === 'routine' && typeof value === 'string' ? (names.get(value) ?? value) : value,
      ) as Routine);

/** The words around the name of a request in the name of its routine: `build …`, `… wanted`. */
function around(routine: Name, request: Name): readonly [string, string] | undefined {
  const at = routine.indexOf(request);
  return at < 0 ? undefined : [routine.slice(0, at), routine.slice(at + request.length)];
}

const routinesOf = ({ build, check, wanted, items }: PlannedRequest): readonly (Name | undefined)[] => [
  build,
  check,
  wanted,
  items?.routine,
];

const titleOf = ({ reading }: PlannedRequest): string => reading.description?.name ?? '';

/**
 * The plan with one routine for those of several requests that do the same: `build write single register` sends to two
 * addresses. It is called by the function if all have that, else by what it is of.
 */
export function shareRoutines(plan: Plan): Plan {
  const owners = (of: Name): readonly PlannedRequest[] => plan.requests.filter((one) => routinesOf(one).includes(of));
  const kept: Routine[] = [];
  const same = new Map<string, Name[]>();
  const names = new Map<Name, Name>();
  for (const routine of plan.code.routines) {
    const now = withCalls(routine, names);
    const does = essence(now);
    const group = owners(routine.name).length > 0 ? same.get(does) : undefined;
    if (group?.[0] !== undefined) {
      group.push(routine.name);
      names.set(routine.name, group[0]);
    } else {
      kept.push(now);
      same.set(does, [routine.name]);
    }
  }
  const taken = new Set<Name>(kept.map(({ name }) => name));
  const called = new Map<Name, { name: Name; about?: string }>();
  for (const group of same.values()) {
    const [first] = group;
    const requests = group.flatMap(owners);
    const [one] = requests;
    const words = first !== undefined && one !== undefined && around(first, one.name);
    if (requests.length < 2 || !words || first === undefined || one === undefined) continue;
    const [before, after] = words;
    const title = titleOf(one);
    taken.delete(first);
    const isOfOne = requests.every((other) => titleOf(other) === title) && plainWords(title) !== '';
    const name = fresh(taken, `${before}${isOfOne ? plainWords(title) : 'reply'}${after}`);
    called.set(first, { name, ...(before === 'build ' && { about: `Builds a request: ${title}.` }) });
  }
  const final = (of: Name): Name => {
    const first = names.get(of) ?? of;
    return called.get(first)?.name ?? first;
  };
  const all = new Map(
    plan.code.routines.flatMap(({ name }) => (final(name) === name ? [] : [[name, final(name)] as const])),
  );
  const routines = kept.map((routine) => {
    const about = called.get(routine.name)?.about;
    return {
      ...withCalls(routine, all),
      name: final(routine.name),
      about: about === undefined ? routine.about : [about],
    };
  });
  return withNames(plan, { ...plan.code, routines }, final);
}

/** The plan with other code, and requests and steps that name its routines. */
function withNames(plan: Plan, code: Code, final: (of: Name) => Name): Plan {
  const maybe = (of: Name | undefined) => of && final(of);
  const requests = new Map(
    plan.requests.map((one) => [
      one,
      {
        ...one,
        build: maybe(one.build),
        check: maybe(one.check),
        wanted: maybe(one.wanted),
        items: one.items && { ...one.items, routine: final(one.items.routine) },
      },
    ]),
  );
  const step = (of: PlannedStep): PlannedStep => {
    if (of.kind === 'wait') return of;
    if (of.kind === 'repeat') return { ...of, steps: of.steps.map(step) };
    return { ...of, request: requests.get(of.request) ?? of.request };
  };
  const { sequence } = plan;
  return {
    ...plan,
    code,
    requests: [...requests.values()],
    sequence: sequence && { steps: sequence.steps.map(step), finally: sequence.finally.map(step) },
  };
}
