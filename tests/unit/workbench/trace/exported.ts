import type { Trace } from '../../../../src/trace/index.ts';
import { trace as words } from '../../../../src/words/en/trace.ts';
import { reportWords } from '../../../../src/words/en/trace-report.ts';
import { type ExportFormat, type ExportSource, exportSteps, type Replaced } from '../../../../src/workbench/index.ts';

/** The bytes of a file that is made of a trace, and what was said of how far it was. */
export function exported(
  trace: Trace,
  format: ExportFormat,
  replaced: Replaced = {},
  of: Omit<ExportSource, 'trace'> = {},
): { readonly bytes: Uint8Array; readonly steps: readonly number[] } {
  const steps: number[] = [];
  const making = exportSteps(
    { ...of, trace },
    { format, replaced },
    { sentence: words.sentence, report: reportWords(words) },
  );
  for (;;) {
    const step = making.next();
    if (!step.done) steps.push(step.value);
    else return { bytes: Buffer.concat(step.value.map((part) => Buffer.from(part as string))), steps };
  }
}
