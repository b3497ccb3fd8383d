import type { Plan } from '../../plan.ts';
import type { Target } from '../../target.ts';
import { Lines, type WrittenFile } from '../../written.ts';
import { structuredTextOf } from '../structured-text/structured-text.ts';
import { rungDrawing } from './drawing.ts';
import { plcOpen } from './plc-open.ts';
import { type Rung, rungOf } from './rung.ts';

/** The rungs that call the blocks, as PLCopen XML and as a drawing; the blocks are written in Structured Text. */
export const ladder: Target = {
  id: 'ladder',
  name: 'Ladder (PLCopen XML)',
  language: 'xml',
  proof: 'rules',
  parts: ['exchange'],
  transports: ['rtu', 'ascii', 'tcp'],
  sequences: true,
  write: (plan: Plan) => {
    const { file: blocks, names } = structuredTextOf(plan);
    const rungs: readonly Rung[] = plan.sequence
      ? [rungOf(undefined, plan.requests, names)]
      : plan.requests.map((request) => rungOf(request, [request], names));
    const drawings = rungs.map((rung, index): WrittenFile => {
      const name = rungs.length === 1 ? 'rung.svg' : `rung-${index + 1}.svg`;
      return new Lines('').text(rungDrawing(rung)).file(name);
    });
    return { files: [new Lines('').text(plcOpen(rungs)).file('rung.xml'), ...drawings, blocks], notes: names.notes };
  },
};
