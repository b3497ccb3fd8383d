import type { MapFaultCode, MapNoticeCode, MapQuestion, QuestionCode } from './codes.ts';
import { Tally } from './tally.ts';

interface Row {
  readonly line: number;
}
export const linesOf = (rows: readonly Row[]): readonly number[] => rows.map(({ line }) => line);

/** What is asked and said of the rows of a file. */
export class Report {
  readonly questions: MapQuestion[] = [];
  readonly faults = new Tally<MapFaultCode>();
  readonly notices = new Tally<MapNoticeCode>();

  /** Asks once for all rows, and says of each that its answer is assumed. No question for no row. */
  ask(code: QuestionCode, options: readonly string[], assumed: string, rows: readonly Row[], example?: string): void {
    if (rows.length === 0) return;
    if (!this.questions.some((question) => question.code === code))
      this.questions.push({ code, options, assumed, ...(example === undefined ? {} : { example }) });
    this.notices.add('assumed', linesOf(rows), { question: code });
  }
}
