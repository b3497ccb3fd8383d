import { computed, effect } from '@preact/signals-core';
import { keptTexts, readTiming, type TimingName, type TimingTexts, timingTexts } from '../workbench/index.ts';
import { AddressedView } from './addressed-view.ts';
import type { Page } from './page.ts';
import type { KeptChoice } from './storage.ts';

/** The Timing view: a line as typed, and the current frame on it. Its address names the frame too. */
export class TimingView extends AddressedView<TimingTexts> {
  readonly reading;
  readonly #last: KeptChoice<TimingTexts>;
  readonly #stopNaming: () => void;

  /** @param last the line and the devices as typed last */
  constructor(page: Page, last: KeptChoice<TimingTexts>) {
    super(
      page,
      'timing',
      (parts) => {
        page.takeFrame(parts.get('frame') ?? '');
        return timingTexts((name) => parts.get(name), last.value);
      },
      (texts) => ({ ...texts, frame: page.link.peek() }),
    );
    this.#last = last;
    this.reading = computed(() => readTiming(this.shown.value, page.draft.value));
    // A frame is pasted here too, and a link is to find it. An address that leaves something out is completed.
    this.#stopNaming = effect(() => {
      if (page.link.value && page.address.given.value && page.view.value === 'timing') this.follow();
    });
  }

  readonly set = (name: TimingName, text: string): void => {
    this.change({ [name]: text });
    this.#last.value = keptTexts(this.shown.value);
  };

  override stop(): void {
    super.stop();
    this.#stopNaming();
  }
}
