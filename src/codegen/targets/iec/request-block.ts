import type { Name } from '../../code.ts';
import type { PlannedRequest } from '../../plan.ts';
import type { Exchanges } from './block.ts';
import { stringLiteral, type Units, type Variable } from './units.ts';

const IDLE = 0;
const RECEIVING = 10;

/** Writes the function block that sends a request, waits for the reply, checks it and gives its values. */
export function requestBlock(units: Units, exchanges: Exchanges, request: PlannedRequest): void {
  const { lines, dialect } = units;
  const v = (name: Name) => exchanges.v(name);
  const input = (name: Name): Name => (OWN.has(name) ? `request ${name}` : name);
  const inputs = request.arguments.map(({ parameter, value }): Variable => {
    const values = typeof value === 'number' ? [value] : value;
    const texts = values.map((one) => units.value(parameter.type, one));
    return {
      name: input(parameter.name),
      type: units.typeOf(parameter),
      value: typeof value === 'number' ? texts[0] : `[${texts.join(', ')}]`,
      comment: parameter.comment,
    };
  });
  const { check, list, values } = request;
  const taken = new Set([...OWN, ...inputs.map(({ name }) => name)]);
  const output = (name: Name): Name => (taken.has(name) ? `reply ${name}` : name);
  const outputs: Variable[] = [];
  if (check)
    outputs.push({ name: 'result', type: dialect.types.int, comment: '0: good; above: exception; below: fault' });
  if (check) outputs.push({ name: 'message', type: dialect.string, comment: 'the result in words' });
  if (list) outputs.push({ name: output(list.name), type: units.typeOf(list), comment: list.comment });
  if (request.items)
    outputs.push({ name: output('item count'), type: dialect.types.int, comment: 'how many of them the reply has' });
  for (const { name, type, unit } of values)
    outputs.push({ name: output(name), type: dialect.types[type], comment: unit === '' ? undefined : `in ${unit}` });

  units.about([request.about, 'Call it in every cycle.']);
  units.unit(
    'FUNCTION_BLOCK',
    request.name,
    undefined,
    exchanges.sections({
      inputs,
      outputs,
      variables: [],
      constants: [],
      requests: [request],
    }),
    [],
    () => {
      const set = (name: Name, value: string) => lines.add(`${v(name)} := ${value};`);
      exchanges.timers(RECEIVING, [request]);
      set('tx start', 'FALSE');
      lines.add('');
      lines.add(`CASE ${v('stage')} OF`).inside(() => {
        lines.add(label(units, IDLE, 'waits for the edge')).inside(() => {
          lines.add(`IF ${v('execute')} AND NOT ${v('was execute')} THEN`).inside(() => {
            set('busy', 'TRUE');
            set('done', 'FALSE');
            set('error', 'FALSE');
            exchanges.send(request, (name) => v(input(name)));
            exchanges.start(RECEIVING, [request]);
          });
          lines.add('END_IF;');
        });
        if (check === undefined) broadcast();
        else receiving();
      });
      lines.add('END_CASE;');
      lines.add('');
      set('was execute', v('execute'));

      function broadcast() {
        lines.add(label(units, RECEIVING, 'a broadcast has no reply: devices get time to carry it out')).inside(() => {
          lines.add(`IF ${v('reply timer')}.Q THEN`).inside(() => {
            set('busy', 'FALSE');
            set('done', 'TRUE');
            set('stage', String(IDLE));
          });
          lines.add('END_IF;');
        });
      }

      function receiving() {
        lines.add(label(units, RECEIVING, 'the reply comes in')).inside(() => {
          exchanges.received();
          if (request.wanted !== undefined) set('wanted', exchanges.wanted(request));
          lines.add(`IF ${exchanges.ended([request])} THEN`).inside(() => {
            set('result', exchanges.check(request, output(list?.name ?? '')));
            set('busy', 'FALSE');
            set('done', `(${v('result')} = 0)`);
            set('error', `(${v('result')} <> 0)`);
            set('stage', String(IDLE));
            message(units, exchanges);
            if (values.length === 0 && request.items === undefined) return;
            lines.add(`IF ${v('done')} THEN`).inside(() => {
              if (request.items) set(output('item count'), exchanges.items(request.items));
              for (const value of values) {
                const [reply] = units.parametersOf(value.routine);
                set(output(value.name), units.call(value.routine, [reply?.name ?? '', exchanges.reply]));
              }
            });
            lines.add('END_IF;');
          });
          lines.add('END_IF;');
        });
      }
    },
  );
}

/** Says the result in words, with texts of one's own for some numbers. */
export function message(
  units: Units,
  exchanges: Exchanges,
  own: readonly (readonly [number: string, text: string])[] = [],
): void {
  const { lines, code } = units;
  const [result, text] = [exchanges.v('result'), exchanges.v('message')];
  const say = (condition: string, what: string) => {
    lines.add(condition).inside(() => lines.add(`${text} := ${what};`));
  };
  const named = (of: Name) => {
    const found = code.texts.find(({ name }) => name === of);
    return found ? units.call(found.name, [found.parameter, result]) : stringLiteral('');
  };
  say(`IF ${result} > 0 THEN`, named('exception name'));
  for (const [number, what] of own) say(`ELSIF ${result} = ${number} THEN`, stringLiteral(what));
  say(`ELSIF ${result} < 0 THEN`, named('fault name'));
  say('ELSE', stringLiteral(''));
  lines.add('END_IF;');
}

/** The label of a stage, with what happens in it. */
export const label = ({ printer, dialect }: Units, stage: number, about: string): string =>
  printer.comments ? `${stage}: ${dialect.comment(about)}` : `${stage}:`;

/** The names of a block's own variables, which no parameter has. */
const OWN: ReadonlySet<Name> = new Set([
  'execute',
  'busy',
  'done',
  'error',
  'result',
  'stage',
  'was execute',
  'reply',
  'reply count',
  'reply timer',
  'silence timer',
  'seen count',
  'wanted',
  'index',
  'tx buffer',
  'tx count',
  'tx start',
  'rx buffer',
  'rx count',
]);
