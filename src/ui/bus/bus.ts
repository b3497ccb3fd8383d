import { effect, untracked } from '@preact/signals';
import { type JobNews, type JobOrder, makeClock, Session, serialSupport, WebSerialLink } from '../../bus/index.ts';
import { Bus, type JobEnd } from '../../store/index.ts';
import { busLink } from '../parts/bus-link.ts';
import { after, storage } from '../parts/store.ts';
import { startWorker } from '../parts/workers/start-worker.ts';

busLink.value = serialSupport(window) ?? busLink.value;

export interface JobFollower {
  news(news: readonly JobNews[]): void;
  ended(end: JobEnd): void;
}

/** What panels use that do not read signals yet. */
class WindowBus extends Bus<SerialPort> {
  get state() {
    return {
      link: this.link.value,
      settings: this.settings.value,
      rules: this.rules.value,
      errors: this.errors.value,
      signals: this.signals.value.inputs,
      signalsTaken: this.signals.value.taken,
      readOnly: this.readOnly.value,
      sending: this.sending.value,
      question: this.question.value,
      refused: this.refused.value,
      serving: this.serving.value,
      last: this.last.value,
      log: this.log.lines,
      cleared: this.log.cleared.value,
      inWindow: this.inWindow.value,
    };
  }

  listen(listener: (state: BusState) => void): () => void {
    return effect(() => {
      this.log.revision.value;
      const { state } = this;
      untracked(() => listener(state));
    });
  }

  startJob(order: JobOrder, follower: JobFollower, transport?: 'rtu' | 'ascii'): () => void {
    this.start(order, (news) => follower.news(news), transport);
    const stop = this.job(order.kind).subscribe((state) => {
      if (state.kind !== 'ended') return;
      untracked(() => follower.ended(state.end));
      queueMicrotask(() => stop());
    });
    return () => this.stop(order.kind);
  }
}

export type BusState = WindowBus['state'];

/** The bus of this window. */
export const bus = new WindowBus({
  link: busLink,
  serial: 'serial' in navigator ? navigator.serial : undefined,
  inWorker: (tell, ended) => startWorker('session', tell, ended),
  inWindow(port, tell) {
    const clock = makeClock();
    let told = tell;
    const session = new Session({
      clock,
      portLink: () => Promise.resolve(new WebSerialLink(port, clock)),
      tell: (news) => told(news),
    });
    return {
      post: (command) => void session.take(command),
      end() {
        told = () => undefined;
      },
    };
  },
  after,
  storage,
});
