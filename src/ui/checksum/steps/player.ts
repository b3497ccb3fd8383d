import { KeptChoice } from '../../../store/index.ts';
import { oneOf } from '../../../workbench/index.ts';
import { storage } from '../../parts/store.ts';

/** StepRows a second that can be chosen. */
export const speeds = [1, 2, 4, 10, 30] as const;
export type Speed = (typeof speeds)[number];

const remembered = new KeptChoice<Speed>(storage, 'checksum-step-speed', 2, oneOf(speeds));

/** Goes on by itself, at the speed chosen last. */
export class Player {
  private readonly advance: () => void;
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(advance: () => void) {
    this.advance = advance;
  }

  get playing(): boolean {
    return this.timer !== undefined;
  }

  get speed(): Speed {
    return remembered.value;
  }

  set speed(speed: Speed) {
    remembered.value = speed;
    if (this.playing) this.play();
  }

  /** Whether there was a faster or slower one to take. */
  faster(by: 1 | -1): void {
    const next = speeds[speeds.indexOf(this.speed) + by];
    if (next !== undefined) this.speed = next;
  }

  play(): void {
    clearInterval(this.timer);
    this.timer = setInterval(this.advance, 1000 / this.speed);
  }

  stop(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }
}
