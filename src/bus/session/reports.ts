import type { Clock } from '../clock.ts';
import type { JobNews } from '../jobs/index.ts';
import { type LineError, noErrors } from '../link/link.ts';
import type { LogLine } from '../log/line.ts';
import type { SessionNews } from './messages.ts';

/** How long news are kept together, in milliseconds: a window draws no more often, and each message costs. */
const TOGETHER = 60;

/** What a session has to tell a window, in batches: lines of the log, what jobs have found, and errors of the line. */
export class Reports {
  readonly #clock: Clock;
  readonly #send: (news: SessionNews) => void;
  #lines: LogLine[] = [];
  #jobNews: { id: number; news: JobNews }[] = [];
  #errors = noErrors;
  #errorsTold = noErrors;
  #waiting = false;

  constructor(clock: Clock, send: (news: SessionNews) => void) {
    this.#clock = clock;
    this.#send = send;
  }

  /** Tells at once, after all that waits. */
  tell(news: SessionNews): void {
    this.#flush();
    this.#send(news);
  }

  lines(lines: readonly LogLine[]): void {
    this.#lines.push(...lines);
    this.#soon();
  }

  readonly line = (line: LogLine): void => {
    this.#lines.push(line);
    this.#soon();
  };

  ofJob(id: number, news: JobNews): void {
    this.#jobNews.push({ id, news });
    this.#soon();
  }

  lineError(error: LineError): void {
    this.#errors = { ...this.#errors, [error]: this.#errors[error] + 1 };
    this.#soon();
  }

  /** Counts the errors of the line from 0 again. */
  forgetErrors(): void {
    this.#errors = noErrors;
  }

  #soon(): void {
    if (this.#waiting) return;
    this.#waiting = true;
    this.#clock.after(TOGETHER, () => this.#flush());
  }

  #flush(): void {
    this.#waiting = false;
    const lines = this.#lines;
    this.#lines = [];
    if (lines.length > 0) this.#send({ kind: 'lines', lines });
    const news = this.#jobNews;
    this.#jobNews = [];
    if (news.length > 0) this.#send({ kind: 'jobs', news });
    if (this.#errors === this.#errorsTold) return;
    this.#errorsTold = this.#errors;
    this.#send({ kind: 'errors', errors: this.#errors });
  }
}
