import { decodeFrame, toHex } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { defaultSettings, type Link, type LinkEvent, type LinkSettings } from '../link/link.ts';
import type { LineKind, LogLine } from '../log/line.ts';
import { piecesOf } from '../transaction/arrivals.ts';
import { anyFrame } from '../transaction/find-frame.ts';
import { LineMemory } from '../transaction/line-memory.ts';
import type { Stray } from '../transaction/result.ts';
import { lineTimes, type TransactionRules } from '../transaction/rules.ts';
import type { VirtualBus } from './virtual-bus.ts';

export interface PortServerParts {
  readonly link: Link;
  readonly clock: Clock;
  /** The devices that answer. */
  readonly bus: VirtualBus;
  readonly rules: () => TransactionRules;
  /** Takes a line of the log. */
  readonly log: (line: LogLine) => void;
}

/**
 * As long as nothing tells whether an adapter has an echo, what may be a request too is an echo no later than this behind its last
 * character, in milliseconds: adapters hand over in lumps.
 */
const ECHO_DELAY = 100;
const EXCEPTION = 0x80;

/**
 * Lets virtual devices answer what arrives on a link. A frame is taken when it is whole and the silence of its speed has
 * followed; adapters hand bytes over in lumps, so that what is not whole is waited for longer.
 */
export class PortServer {
  readonly #parts: PortServerParts;
  readonly #offLink: () => void;
  readonly #line = new LineMemory();
  #offSilence = () => {};
  /** The last reply, which an adapter may give back. */
  #sent: { readonly hex: string; readonly isRequest: boolean; readonly until: number } | undefined;
  #stopped = false;

  constructor(parts: PortServerParts) {
    this.#parts = parts;
    this.#offLink = parts.link.listen((event) => this.#take(event));
  }

  /** Nothing is answered any longer, also what has been asked already. */
  stop(): void {
    this.#stopped = true;
    this.#offLink();
    this.#offSilence();
  }

  #take(event: LinkEvent): void {
    if (event.kind !== 'received') return;
    const { clock, rules } = this.#parts;
    const line = this.#line;
    const { transport } = rules();
    for (const piece of piecesOf(event.bytes)) {
      for (const gone of line.add(piece, event.at, transport)) this.#hear(gone);
    }
    const { gap, silence } = lineTimes(this.#settings(), rules());
    this.#offSilence();
    this.#offSilence = clock.after(endsWhole(line.arrivals.bytes, transport) ? gap : silence, () => {
      for (const piece of line.drain(transport)) this.#hear(piece);
    });
  }

  #hear({ bytes, at, what }: Stray): void {
    if (what !== 'noise' && this.#isEcho(bytes, at)) {
      this.#log('echo', bytes, at);
      return;
    }
    const { bus, link, clock } = this.#parts;
    let asked = false;
    const off = bus.listen((event) => {
      if (event.kind === 'heard' && (event.does === 'answer' || event.why === 'broadcast')) asked = true;
    });
    bus.hear(bytes, this.#settings(), (reply) => {
      if (this.#stopped) return;
      const now = clock.now();
      const { characters } = lineTimes(this.#settings(), this.#parts.rules());
      const until = now + characters(reply.length) + ECHO_DELAY;
      this.#sent = { hex: toHex(reply), isRequest: toHex(reply) === toHex(bytes), until };
      void link.write(reply);
      this.#log(this.#kindOf(reply, bytes), reply, now, 'sent');
    });
    off();
    this.#log(what === 'noise' ? 'noise' : asked ? 'request' : 'heard', bytes, at);
  }

  /**
   * Whether this is what was sent last, given back by the adapter, however late: nobody else sends a reply of this device. One that is the
   * same as its request could be that request once more: what others have told of the adapter decides, or else the time.
   */
  #isEcho(bytes: Uint8Array, at: number): boolean {
    const sent = this.#sent;
    const { echo } = this.#parts.rules();
    if (sent === undefined || echo === 'off') return false;
    this.#sent = undefined;
    const isCopy = sent.hex.includes(toHex(bytes));
    if (isCopy && sent.isRequest) return echo === 'on' || (this.#line.echoes ?? at <= sent.until);
    this.#line.echoes = isCopy;
    return isCopy;
  }

  #kindOf(reply: Uint8Array, request: Uint8Array): LineKind {
    const { transport } = this.#parts.rules();
    const { outcome, forced, functionCode = 0 } = decodeFrame(reply, { transport, direction: 'response', request });
    if (outcome.kind !== 'whole' || 'checksum' in forced) return 'broken';
    return (functionCode & EXCEPTION) !== 0 ? 'exception' : 'reply';
  }

  #settings(): LinkSettings {
    const { state } = this.#parts.link;
    return state.kind === 'open' ? state.settings : defaultSettings;
  }

  #log(kind: LineKind, bytes: Uint8Array, at: number, direction: LogLine['direction'] = 'received'): void {
    const { clock, rules, log } = this.#parts;
    log({ time: clock.origin + at, direction, transport: rules().transport, kind, hex: toHex(bytes) });
  }
}

/** Whether the last of these bytes ends a frame. */
function endsWhole(bytes: Uint8Array, transport: TransactionRules['transport']): boolean {
  for (let rest = bytes; ; ) {
    const frame = anyFrame(rest, transport);
    if (frame === undefined) return false;
    if (frame.to === rest.length) return true;
    rest = rest.subarray(frame.to);
  }
}
