import type { Clock } from '../clock.ts';
import type { JobNews } from '../jobs/index.ts';
import { type LineError, noErrors } from '../link/link.ts';
import type { LogLine } from '../log/line.ts';
import type { SessionNews } from './messages.ts';

/** News are kept together for so long, in milliseconds: a window draws no oftener, and each message costs. */
const TOGETHER = 60;

/** What a session has to tell a window, in its order: lines of the log, what jobs have found, and errors of the line in batches. */
export class Reports {
  readonly #clock: Clock;
  readonly #send: (news: SessionNews) => void;
  #logged = 0;
  #lines: LogLine[] = [];
  #jobNews: { id: number; news: JobNews }[] = [];
  #errors = noErrors;
  #waiting = false;

  constructor(clock: Clock, send: (news: SessionNews) => void) {
    this.#clock = clock;
    this.#send = send;
  }

  /** The number that the next line of the log has. */
  get next(): number {
    return this.#logged + 1;
  }

  /** Tells at once, behind all that waits. */
  tell(news: SessionNews): void {
    this.#flush();
    this.#send(news);
  }

  lines(lines: readonly LogLine[]): void {
    this.#logged += lines.length;
    this.#lines.push(...lines);
    this.#soon();
  }

  /** Writes one line; answers its number. */
  readonly line = (line: Omit<LogLine, 'number'>): number => {
    this.lines([{ number: this.next, ...line }]);
    return this.#logged;
  };

  ofJob(id: number, news: JobNews): void {
    this.#jobNews.push({ id, news });
    this.#soon();
  }

  lineError(error: LineError): void {
    this.#errors = { ...this.#errors, [error]: this.#errors[error] + 1 };
    this.#soon();
  }

  /** Counts the errors of the line anew. */
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
    this.#send({ kind: 'errors', errors: this.#errors });
  }
}
