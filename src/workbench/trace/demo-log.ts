import { type Clock, type Fault, sourceServers, VirtualBus } from '../../bus/index.ts';
import { encodeFrame, type SerialLine } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';

/** A clock that goes on from one timer to the next. */
class SteppedClock implements Clock {
  readonly origin = 0;
  #now = 0;
  #timers: { readonly due: number; readonly then: () => void }[] = [];

  now(): number {
    return this.#now;
  }

  after(delay: number, then: () => void): () => void {
    const timer = { due: this.#now + Math.max(0, delay), then };
    this.#timers.push(timer);
    return () => {
      this.#timers = this.#timers.filter((other) => other !== timer);
    };
  }

  /** Lets all happen that is due until a time. */
  until(time: number): void {
    for (;;) {
      const next = this.#timers.toSorted((one, other) => one.due - other.due)[0];
      if (next === undefined || next.due > time) break;
      this.#timers = this.#timers.filter((other) => other !== next);
      this.#now = next.due;
      next.then();
    }
    this.#now = time;
  }
}

/** Numbers from 0 to 255 in an order that is always the same (xorshift of 32 bits). */
function seeded(seed: number): () => number {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return state & 0xff;
  };
}

interface Asked {
  readonly unitId: number;
  readonly functionCode: number;
  readonly fields: Readonly<Record<string, number>>;
}

const read = (unitId: number, functionCode: number, address: number, quantity: number): Asked => ({
  unitId,
  functionCode,
  fields: { startAddress: address, quantity },
});

/** What the master of the demo log asks in turn: a drive, a power meter and an input module. */
const ROUND: readonly Asked[] = [read(6, 3, 681, 2), read(1, 3, 0, 4), read(17, 3, 107, 3)];
/** Beyond the last parameter of the drive. */
const NOT_THERE = read(6, 3, 999, 1);
const REQUESTS = 101;

/** What goes wrong, by the number of the request from 0. */
const PLANTED: ReadonlyMap<number, Fault | 'not-there' | 'bit'> = new Map<number, Fault | 'not-there' | 'bit'>([
  [17, 'not-there'],
  [31, { kind: 'silence' }],
  [46, 'bit'],
  [60, 'not-there'],
  [74, { kind: 'exception', exceptionCode: 6 }],
  [91, { kind: 'silence' }],
]);

const LINE: SerialLine = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 };
const START = ((10 * 60 + 31) * 60 + 12) * 1000;
const EACH = 250;
const TIMEOUT = 1000;
const BIT = 0x10;
const BYTE = 4;

/**
 * A log as Modbus Poll writes it, with the times of day: 200 frames of our own virtual bus, always the same, with six faults in it: three
 * exceptions, a reply with one wrong bit, and two requests without a reply.
 */
export function demoLog(): string {
  const clock = new SteppedClock();
  const chance = seeded(0x2545f491);
  const bus = new VirtualBus(clock, sourceServers(), chance);
  const lines: string[] = [];
  const write = (side: 'Tx' | 'Rx', bytes: Uint8Array) => {
    const number = String(lines.length).padStart(6, '0');
    lines.push(`${clockText(START + clock.now())} ${side}:${number}-${formatBytes(bytes)}`);
  };
  let at = 0;
  for (let number = 0; number < REQUESTS; number++) {
    clock.until(at);
    const planted = PLANTED.get(number);
    const asked = planted === 'not-there' ? NOT_THERE : (ROUND[number % ROUND.length] ?? NOT_THERE);
    const request = encodeFrame({ transport: 'rtu', direction: 'request', ...asked });
    bus.faults = typeof planted === 'object' ? [{ fault: planted, unit: asked.unitId, times: 1 }] : [];
    write('Tx', request);
    bus.send(request, LINE, (reply) => {
      write('Rx', planted === 'bit' ? reply.with(BYTE, (reply[BYTE] ?? 0) ^ BIT) : reply);
    });
    const silent = typeof planted === 'object' && planted.kind === 'silence';
    at += (silent ? TIMEOUT : EACH) + (chance() % 8);
  }
  clock.until(at);
  return `${lines.join('\n')}\n`;
}

function clockText(milliseconds: number): string {
  const whole = Math.round(milliseconds);
  const two = (value: number) => String(Math.floor(value)).padStart(2, '0');
  const seconds = whole / 1000;
  return `${two(seconds / 3600)}:${two((seconds / 60) % 60)}:${two(seconds % 60)}.${String(whole % 1000).padStart(3, '0')}`;
}
