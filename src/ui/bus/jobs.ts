import { computed, effect } from '@preact/signals';
import { Listening, MapReading, NoAnswer, Poll, Scan, SequenceRun, Sequences } from '../../store/index.ts';
import { mapReading } from '../parts/bus-link.ts';
import { commands, page, storage } from '../parts/store.ts';
import { bus } from './bus.ts';

// What this window has the bus do. All of it goes on while another view is shown.

export const poll = new Poll(bus, storage);
mapReading.value = new MapReading(bus, poll.settings);
export const scan = new Scan(bus, storage);
export const listening = new Listening(bus);
export const sequences = new Sequences(storage);
export const run = new SequenceRun(bus);
export const noAnswer = new NoAnswer(
  bus,
  scan,
  computed(() => {
    const { frame } = page.evaluation.value;
    const transport = page.transport.value;
    const isRequest = page.kind.value === 'request' && (transport === 'rtu' || transport === 'ascii');
    return frame && isRequest ? { request: frame.bytes, transport } : undefined;
  }),
);

effect(() => (run.running.value ? commands.offer('stop', run.stopSteps) : undefined));
