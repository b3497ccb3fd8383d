import fc from 'fast-check';
import { expect, it } from 'vitest';
import { spacedHex } from '../../../../src/modbus/index.ts';
import { besides, type TraceInput, traceOf } from '../../../../src/trace/index.ts';
import { trace as words } from '../../../../src/words/en/trace.ts';
import { Describer, exchangeRowOf, filterOf, type RowUnit, rowOf } from '../../../../src/workbench/index.ts';
import { hex } from '../../captures/wire.ts';
import { anyAct, anyTwoWorlds, happened } from './worlds.ts';

const place = { kind: 'text', from: 0, to: 0 } as const;
/** What a filter for a text looks in, made anew for each row. */
function plainTexts(trace: ReturnType<typeof traceOf>, by: RowUnit): readonly string[] {
  const make = by === 'frame' ? rowOf : exchangeRowOf;
  return Array.from({ length: by === 'frame' ? trace.size : trace.exchangeCount }, (_, index) => {
    const row = make(trace, index, undefined);
    return `${words.sentence(row)} ${spacedHex(row.hex)} ${spacedHex(row.reply?.hex ?? '')}`.toLowerCase();
  });
}

function kept(trace: ReturnType<typeof traceOf>, by: RowUnit, text: string): readonly number[] {
  const { test } = filterOf([{ is: 'text', not: false, text }]);
  const describer = new Describer(trace, by, { says: words.sentence });
  const size = by === 'frame' ? trace.size : trace.exchangeCount;
  return Array.from({ length: size }, (_, index) => index).filter((index) => test(describer.at(index)));
}

it('finds the rows whose text has another one, as if each text was made anew', () => {
  const anyBeside: fc.Arbitrary<TraceInput> = fc.constantFrom(...besides).map((beside) => {
    return { bytes: hex('01 83 02 C0 F1'), transport: 'rtu', side: 'response', place, known: { beside } };
  });
  fc.assert(
    fc.property(
      anyTwoWorlds,
      fc.array(anyAct, { minLength: 1, maxLength: 8 }),
      fc.array(anyBeside, { maxLength: 2 }),
      fc.constantFrom<RowUnit>('frame', 'exchange'),
      fc.nat(),
      fc.nat(),
      fc.integer({ min: 1, max: 12 }),
      ([world], acts, others, by, row, from, length) => {
        // What happens twice says the same, at another time.
        const trace = traceOf([...happened(world, [...acts, ...acts]), ...others]);
        const texts = plainTexts(trace, by);
        const text = texts[row % texts.length] ?? '';
        const wanted = text.slice(from % text.length).slice(0, length);
        fc.pre(wanted !== '');
        const found = texts.flatMap((one, index) => (one.includes(wanted) ? [index] : []));
        expect(kept(trace, by, wanted.toUpperCase())).toEqual(found);
      },
    ),
    { numRuns: 100 },
  );
});
