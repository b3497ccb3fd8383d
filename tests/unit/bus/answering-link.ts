import type { LinkSettings, LinkState } from '../../../src/bus/index.ts';
import { ScriptedLink } from './scripted-link.ts';
import type { VirtualClock } from './virtual-clock.ts';

const adapter = { kind: 'virtual' } as const;

/** A link behind which something answers each request, or not, some milliseconds later; it opens as it is told. */
export class AnsweringLink extends ScriptedLink {
  readonly #clock: VirtualClock;
  readonly #answer: (request: Uint8Array, settings: LinkSettings) => readonly [number, Uint8Array] | undefined;
  /** What it was opened with, in the order. */
  readonly opened: LinkSettings[] = [];
  /** Speeds that the port does not know. */
  unknown: readonly number[] = [];

  constructor(clock: VirtualClock, answer: AnsweringLink['answer'], settings?: LinkSettings) {
    super(clock, settings);
    this.#clock = clock;
    this.#answer = answer;
  }

  private get answer() {
    return this.#answer;
  }

  override async open(settings?: LinkSettings): Promise<LinkState> {
    if (settings === undefined) return this.state;
    this.opened.push(settings);
    this.become({ kind: 'opening', adapter, settings });
    const known = !this.unknown.includes(settings.baud);
    this.become(
      known
        ? { kind: 'open', adapter, settings, since: this.#clock.now() }
        : { kind: 'failed', adapter, settings, message: 'no such speed' },
    );
    return this.state;
  }

  override async write(bytes: Uint8Array): Promise<boolean> {
    const { state } = this;
    const reply = state.kind === 'open' ? this.answer(bytes, state.settings) : undefined;
    this.replies.push(reply ? [{ after: reply[0], bytes: reply[1] }] : []);
    return super.write(bytes);
  }
}
