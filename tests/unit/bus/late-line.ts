// A line whose device is late, repeats itself or is right, on a virtual clock: which replies are shown as good, and whether
// they are the device's answers to just these requests. The tests and `npm run bench:late` share it.
import { BusClient, defaultSettings, type TransactionResult, type TransactionRules } from '../../../src/bus/index.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

/** Numbers from 0 to 1 that look random and are the same for a seed (mulberry32). */
export function randomFrom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A frame with its CRC, worked out here bit by bit. */
export function framed(...bytes: readonly number[]): Uint8Array {
  let crc = 0xffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xa001 : crc >>> 1;
  }
  return Uint8Array.from([...bytes, crc & 0xff, crc >> 8]);
}

/** What the device makes of one request. Times are milliseconds from the request. */
export interface Answer {
  readonly after: number;
  readonly bytes: Uint8Array;
}

/** What a kind of device sends: `reply` is its right answer, `usual` the time it takes when nothing is wrong. */
export type Device = (parts: {
  readonly random: () => number;
  readonly reply: Uint8Array;
  readonly refuse: (code: number) => Uint8Array;
  readonly usual: number;
  readonly timeout: number;
  /** Counted from 0. */
  readonly number: number;
}) => readonly Answer[];

/** What the registers hold: new values with each request, always the same, zeros throughout, or 0 or 1 by chance. */
export type Held = 'changing' | 'constant' | 'equal' | 'bits';

export interface Case {
  readonly device: Device;
  /** The device answers one request after another: one that is late delays those behind it. */
  readonly queues?: boolean;
  /** A request that comes while the device is busy is lost. */
  readonly drops?: boolean;
  /** The time the device takes when nothing is wrong. */
  readonly usual: readonly [least: number, most: number];
  readonly held?: Held;
  readonly rules: Partial<TransactionRules> & { readonly timeout: number };
  /** From the beginning of a round of requests to that of the next. */
  readonly interval: number;
  readonly requests?: readonly Uint8Array[];
}

export interface Tally {
  transactions: number;
  good: number;
  /** Shown as good, and not the device's answer to this request. */
  wrong: number;
  doubtful: number;
  /** The right reply came within the time-out. */
  answered: number;
  /** Of those, how many were shown as good, as doubtful and as bad. */
  answeredGood: number;
  answeredDoubtful: number;
  answeredBad: number;
  /** The longest run of doubtful transactions. */
  run: number;
  /** How long right replies were held back, in all, and how many. */
  delay: number;
  delayed: number;
  /** What the transactions took, in all. */
  time: number;
  /** How often it was said that the time-out is too short. */
  slow: number;
}

const UNIT = 17;
const READ = 3;
/** Four pairs of registers, far from each other. */
export const fourReads: readonly Uint8Array[] = [0, 10, 20, 30].map((address) => framed(UNIT, READ, 0, address, 0, 2));

/** The device's right answer to a read of registers, or to a write of one. */
function rightReply(request: Uint8Array, number: number, held: Held): Uint8Array {
  const [unit = 0, code = 0, , address = 0, , quantity = 0] = request;
  if (code === 6 || code === 5) return request;
  const values = Array.from({ length: quantity }, (_, at) => {
    if (held === 'equal') return 0;
    if (held === 'bits') return at === 0 && randomFrom(1000 * number + address)() < 0.5 ? 1 : 0;
    return held === 'constant' ? 1000 + address + at : (number * 31 + address * 7 + at) & 0xffff;
  });
  return framed(unit, code, 2 * quantity, ...values.flatMap((value) => [value >> 8, value & 0xff]));
}

/** A link with such a device behind it. */
class LateLink extends ScriptedLink {
  /** Of each sending: its right answer, and when its first byte came, if it did. */
  readonly sendings: { request: Uint8Array; right: Uint8Array; cameAt: number | undefined; at: number }[] = [];
  readonly #clock: VirtualClock;
  readonly #case: Case;
  readonly #random: () => number;
  #freeAt = 0;

  constructor(clock: VirtualClock, one: Case, random: () => number) {
    super(clock, { ...defaultSettings, baud: 19200, parity: 'none' });
    this.#clock = clock;
    this.#case = one;
    this.#random = random;
  }

  override async write(bytes: Uint8Array): Promise<boolean> {
    const { device, queues, drops, usual, rules, held = 'changing' } = this.#case;
    const now = this.#clock.now();
    const number = this.sendings.length;
    const right = rightReply(bytes, number, held);
    const sending = { request: bytes, right, cameAt: undefined as number | undefined, at: now };
    this.sendings.push(sending);
    this.replies.push([]);
    if (drops && this.#freeAt > now) return super.write(bytes);
    const [least, most] = usual;
    const random = this.#random;
    const refuse = (code: number) => framed(bytes[0] ?? 0, (bytes[1] ?? 0) | 0x80, code);
    const took = least + (most - least) * random();
    const answers = device({ random, reply: right, refuse, usual: took, timeout: rules.timeout, number });
    const from = queues ? Math.max(now, this.#freeAt) : now;
    for (const { after, bytes: answer } of answers) {
      this.#freeAt = Math.max(this.#freeAt, from + after);
      this.#clock.after(from + after - now, () => {
        if (answer === right) sending.cameAt ??= this.#clock.now();
        this.receive(answer);
      });
    }
    return super.write(bytes);
  }
}

/** Carries out so many transactions, in rounds, and counts what became of them. */
export async function tallyOf(one: Case, transactions: number, seed: number): Promise<Tally> {
  const clock = new VirtualClock();
  const link = new LateLink(clock, one, randomFrom(seed));
  const client = new BusClient(link, clock, { gap: 0, echo: 'off', ...one.rules });
  const { requests = fourReads, interval } = one;
  const tally: Tally = {
    transactions: 0,
    good: 0,
    wrong: 0,
    doubtful: 0,
    answered: 0,
    answeredGood: 0,
    answeredDoubtful: 0,
    answeredBad: 0,
    run: 0,
    delay: 0,
    delayed: 0,
    time: 0,
    slow: 0,
  };
  let run = 0;
  while (tally.transactions < transactions) {
    const began = clock.now();
    for (const request of requests) {
      const from = link.sendings.length;
      const result = await clock.until(client.transact(request).result, 1_000_000);
      const sendings = link.sendings.slice(from);
      add(tally, result, sendings, one.rules.timeout);
      run = result.verdict === 'doubtful' ? run + 1 : 0;
      tally.run = Math.max(tally.run, run);
    }
    await clock.advance(Math.max(0, began + interval - clock.now()));
  }
  return tally;
}

function add(tally: Tally, result: TransactionResult, sendings: LateLink['sendings'], timeout: number): void {
  const { outcome, verdict } = result;
  const text = 'bytes' in outcome ? outcome.bytes.join() : '';
  tally.transactions += 1;
  tally.time += result.endedAt - result.queuedAt;
  if (result.slow !== undefined) tally.slow += 1;
  if (verdict === 'doubtful') tally.doubtful += 1;
  if (verdict === 'good') {
    tally.good += 1;
    if (!sendings.some(({ right }) => right.join() === text)) tally.wrong += 1;
  }
  const inTime = sendings.find(({ cameAt, at }) => cameAt !== undefined && cameAt - at <= timeout);
  if (inTime === undefined) return;
  tally.answered += 1;
  if (verdict === 'good') tally.answeredGood += 1;
  if (verdict === 'doubtful') tally.answeredDoubtful += 1;
  if (verdict === 'bad') tally.answeredBad += 1;
  const delay = result.endedAt - (inTime.cameAt ?? 0);
  if (delay > 1e-6) {
    tally.delayed += 1;
    tally.delay += delay;
  }
}

const right: Device = ({ reply, usual }) => [{ after: usual, bytes: reply }];
const between = (random: () => number, least: number, most: number) => least + (most - least) * random();

/** The kinds of devices, each with what it does wrong. */
export const devices = {
  right,
  /** One of twenty replies comes after the time-out. */
  sometimesLate:
    (share = 0.05, least = 1.05, most = 1.9): Device =>
    ({ random, reply, usual, timeout }) => [
      { after: random() < share ? timeout * between(random, least, most) : usual, bytes: reply },
    ],
  /** One of ten replies comes twice. */
  doubles:
    (least = 7, most = 7, share = 0.1): Device =>
    ({ random, reply, usual }) => [
      { after: usual, bytes: reply },
      ...(random() < share ? [{ after: usual + between(random, least, most), bytes: reply }] : []),
    ],
  /** One of ten requests is refused, and answered later all the same. */
  lateAfterException:
    (code: number, share = 0.1): Device =>
    ({ random, reply, refuse, usual, timeout }) =>
      random() < share
        ? [
            { after: usual, bytes: refuse(code) },
            { after: usual + timeout * between(random, 0.1, 1.8), bytes: reply },
          ]
        : [{ after: usual, bytes: reply }],
  always:
    (least: number, most: number): Device =>
    ({ random, reply, timeout }) => [{ after: timeout * between(random, least, most), bytes: reply }],
  /** One of twenty requests is not answered. */
  loses:
    (share = 0.05): Device =>
    ({ random, reply, usual }) =>
      random() < share ? [] : [{ after: usual, bytes: reply }],
  /** Something else comes before the right reply, half of the time: frames of others, of other functions, and damaged ones. */
  disturbed: (): Device => (parts) => {
    const { random, reply, usual } = parts;
    const byte = () => Math.floor(random() * 256);
    const place = 1 + Math.floor(random() * (reply.length - 1));
    const before: readonly (() => Uint8Array)[] = [
      () => framed(UNIT, 6, 0, 1, byte(), byte()),
      () => framed(UNIT, 16, 0, 1, 0, 2),
      () => framed(UNIT, 4, 4, byte(), byte(), byte(), byte()),
      () => framed(UNIT, READ, 2, byte(), byte()),
      () => framed(UNIT, 0x86, 2),
      () => framed(UNIT, 1, 1, byte()),
      () => framed(33, READ, 4, byte(), byte(), byte(), byte()),
      () => framed(33, 6, 0, 1, byte(), byte()),
      () => Uint8Array.of(0),
      () => Uint8Array.from({ length: 1 + Math.floor(random() * 20) }, byte),
      () => reply.with(place, (reply[place] ?? 0) ^ (1 + Math.floor(random() * 255))),
      () => reply.subarray(0, place),
      () => reply.subarray(place),
      () => Uint8Array.from([...reply.subarray(0, place), ...reply.subarray(place + 1)]),
    ];
    if (random() < 0.5) return [{ after: usual, bytes: reply }];
    const bytes = before[Math.floor(random() * before.length)]?.() ?? reply;
    return [...(bytes.length > 0 ? [{ after: usual * random(), bytes }] : []), { after: usual, bytes: reply }];
  },
  /** Late, doubled, refused before it is answered, and lost. */
  everything: (): Device => (parts) => {
    const kinds = [devices.sometimesLate(0.2), devices.doubles(), devices.lateAfterException(6), devices.loses()];
    return (kinds[Math.floor(parts.random() * kinds.length)] ?? right)(parts);
  },
} as const;

/** A kind of line, and what is to be reached on it. */
export interface Kind extends Pick<Case, 'device' | 'usual' | 'queues' | 'drops'> {
  readonly name: string;
  /**
   * `clean`: nothing is doubtful or held back. `some`: nine of ten right replies are shown as good. `any`: nothing wrong.
   * `undecidable`: replies come in another order than their requests, more than the quiet time late, and nothing in them tells
   * which request they answer; two in a thousand at most are wrong.
   */
  readonly target: 'clean' | 'some' | 'any' | 'undecidable';
}

const VARIED = [12, 25] as const;

export const kinds: readonly Kind[] = [
  { name: 'right, 15 ms', device: right, usual: [15, 15], target: 'clean' },
  { name: 'right, 15 to 25 ms', device: right, usual: [15, 25], target: 'clean' },
  { name: 'right, 0.3 to 50 ms', device: right, usual: [0.3, 50], target: 'clean' },
  { name: 'sometimes late', device: devices.sometimesLate(), usual: VARIED, target: 'some' },
  { name: 'sometimes late, one by one', device: devices.sometimesLate(), usual: VARIED, queues: true, target: 'some' },
  { name: 'sometimes late, then deaf', device: devices.sometimesLate(), usual: VARIED, drops: true, target: 'some' },
  {
    name: 'up to four time-outs late',
    device: devices.sometimesLate(0.05, 1.05, 4),
    usual: VARIED,
    queues: true,
    target: 'some',
  },
  { name: 'doubles after 7 of 15 ms', device: devices.doubles(), usual: [15, 15], target: 'some' },
  { name: 'doubles after 1 to 11 ms', device: devices.doubles(1, 11), usual: VARIED, target: 'some' },
  { name: 'doubles after 1 to 30 ms', device: devices.doubles(1, 30), usual: VARIED, target: 'some' },
  { name: 'doubles after 1 to 60 ms', device: devices.doubles(1, 60), usual: VARIED, target: 'some' },
  { name: 'doubles every reply', device: devices.doubles(1, 30, 1), usual: VARIED, target: 'some' },
  { name: 'refuses (02), then answers', device: devices.lateAfterException(2), usual: VARIED, target: 'some' },
  { name: 'refuses (06), then answers', device: devices.lateAfterException(6), usual: VARIED, target: 'some' },
  { name: 'always 1.33 time-outs', device: devices.always(1.33, 1.33), usual: VARIED, target: 'any' },
  { name: 'always 1.1 to 1.9', device: devices.always(1.1, 1.9), usual: VARIED, queues: true, target: 'any' },
  { name: 'always 2.5', device: devices.always(2.5, 2.5), usual: VARIED, queues: true, target: 'any' },
  { name: 'always 1.1 to 1.9, any order', device: devices.always(1.1, 1.9), usual: VARIED, target: 'any' },
  { name: 'late half of the time', device: devices.sometimesLate(0.5), usual: VARIED, target: 'any' },
  {
    name: 'up to eight time-outs late',
    device: devices.sometimesLate(0.05, 1.05, 8),
    usual: VARIED,
    queues: true,
    target: 'any',
  },
  {
    name: '1 to 4 late, any order',
    device: devices.sometimesLate(0.05, 1.05, 4),
    usual: VARIED,
    target: 'undecidable',
  },
  { name: '2 to 6 late, any order', device: devices.sometimesLate(0.05, 2, 6), usual: VARIED, target: 'undecidable' },
  { name: 'always 1.1 to 3, any order', device: devices.always(1.1, 3), usual: VARIED, target: 'undecidable' },
  { name: 'always 0.5 to 3, any order', device: devices.always(0.5, 3), usual: VARIED, target: 'undecidable' },
  { name: 'answers 19 of 20', device: devices.loses(), usual: VARIED, target: 'any' },
  { name: 'other frames and noise before', device: devices.disturbed(), usual: VARIED, target: 'some' },
  { name: 'all of these', device: devices.everything(), usual: VARIED, target: 'any' },
];

/** What is not as it should be; empty if all is. */
export function missed({ target }: Kind, tally: Tally): readonly string[] {
  const { wrong, doubtful, delayed, answered, answeredGood, answeredBad } = tally;
  return [
    ...(wrong > (target === 'undecidable' ? tally.transactions / 500 : 0) ? [`${wrong} wrong`] : []),
    ...((target === 'clean' || target === 'some') && answeredBad > 0.001 * answered
      ? [`${answeredBad} of ${answered} bad`]
      : []),
    ...(target === 'clean' && doubtful + delayed > 0 ? [`${doubtful} doubtful, ${delayed} held back`] : []),
    ...(target === 'some' && answeredGood < 0.9 * answered ? [`${answeredGood} of ${answered} good`] : []),
  ];
}
