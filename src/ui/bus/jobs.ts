import { effect } from '@preact/signals';
import { Listening, Poll, Scan, SequenceRun, Sequences } from '../../store/index.ts';
import { commands, storage } from '../parts/store.ts';
import { bus } from './bus.ts';

// What this window has the bus do. All of it goes on while another view is shown.

export const poll = new Poll(bus, storage);
export const scan = new Scan(bus, storage);
export const listening = new Listening(bus);
export const sequences = new Sequences(storage);
export const run = new SequenceRun(bus);

const askBeforeLeaving = (event: BeforeUnloadEvent): void => event.preventDefault();

effect(() => {
  if (!run.running.value) return;
  const endOffer = commands.offer('stop', run.stopSteps);
  addEventListener('beforeunload', askBeforeLeaving);
  return () => {
    endOffer();
    removeEventListener('beforeunload', askBeforeLeaving);
  };
});
