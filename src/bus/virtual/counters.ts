/** The counters of a serial device, by the sub-function of 08 that reads each (AP 6.8.1). */
export const counterNames = {
  11: 'busMessages',
  12: 'busErrors',
  13: 'exceptions',
  14: 'serverMessages',
  15: 'noResponses',
  16: 'naks',
  17: 'busies',
  18: 'overruns',
} as const;
export type CounterName = (typeof counterNames)[keyof typeof counterNames];

/** What a device remembers of a message (AP 6.10). */
const RECEIVED = 0x80;
const RECEIVED_BROADCAST = 0x40;
const IN_LISTEN_ONLY = 0x20;
const COMMUNICATION_ERROR = 0x02;
const SENT = 0x40;
const ENTERED_LISTEN_ONLY = 0x04;
const RESTARTED = 0x00;
const MOST_EVENTS = 64;
const WORD = 0xffff;

/** In the sending event, the kind of exception by its code (AP 6.10). */
const EXCEPTION_BITS: Readonly<Record<number, number>> = { 1: 1, 2: 1, 3: 1, 4: 2, 5: 4, 6: 4, 7: 8 };

/** What a device counts and remembers of its line, for 08, 0B and 0C. Counts are of 16 bits and start again at 0. */
export class Counters {
  counts: Record<CounterName, number> = zeros();
  /** Requests that were carried out, but for those that ask for this count (AP 6.9). */
  eventCount = 0;
  diagnosticRegister = 0;
  listenOnly = false;
  /** The last event first. */
  events: number[] = [];

  add(name: CounterName): void {
    this.counts[name] = (this.counts[name] + 1) & WORD;
  }

  clear(): void {
    this.counts = zeros();
    this.eventCount = 0;
    this.diagnosticRegister = 0;
  }

  restart(clearLog: boolean): void {
    this.clear();
    this.listenOnly = false;
    if (clearLog) this.events = [];
    this.#remember(RESTARTED);
  }

  enterListenOnly(): void {
    this.listenOnly = true;
    this.#remember(ENTERED_LISTEN_ONLY);
  }

  brokenFrame(): void {
    this.add('busErrors');
    this.#remember(RECEIVED | COMMUNICATION_ERROR | this.#mode());
  }

  received(broadcast: boolean): void {
    this.#remember(RECEIVED | (broadcast ? RECEIVED_BROADCAST : 0) | this.#mode());
  }

  sent(exceptionCode: number | undefined): void {
    this.#remember(SENT | this.#mode() | (exceptionCode === undefined ? 0 : (EXCEPTION_BITS[exceptionCode] ?? 0)));
  }

  carriedOut(): void {
    this.eventCount = (this.eventCount + 1) & WORD;
  }

  #mode(): number {
    return this.listenOnly ? IN_LISTEN_ONLY : 0;
  }

  #remember(event: number): void {
    this.events = [event, ...this.events].slice(0, MOST_EVENTS);
  }
}

const zeros = (): Record<CounterName, number> => ({
  busMessages: 0,
  busErrors: 0,
  exceptions: 0,
  serverMessages: 0,
  noResponses: 0,
  naks: 0,
  busies: 0,
  overruns: 0,
});
