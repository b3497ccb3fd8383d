import type { Refusal } from '../../bus/index.ts';
import { describeFunction } from '../../modbus/index.ts';
import { bus } from './bus.ts';
import { byteHex, code, plural } from './common.ts';

/** What listening says. */
export const listen = {
  intro:
    'Nothing is sent. What a master and its devices say to each other is split into frames, paired, and written into the log. The speed and format must be those of the line.',
  start: 'Listen',
  stop: 'Stop listening',
  notConnected: 'Connect first, to an adapter or to the virtual bus.',
  running: 'Listening. Nothing can be sent meanwhile.',
  ended: {
    stopped: 'Listening was stopped.',
    lost: 'The adapter was lost, and listening has ended. What was heard is kept.',
    disconnected: 'The connection was closed, and listening has ended. What was heard is kept.',
    declined: 'Not begun.',
  },
  refused: (why: Refusal) => bus.guard.refusals[why],
  heard: (frames: number, noise: number) =>
    `${plural(frames, 'frame')} heard${noise > 0 ? `, and ${plural(noise, 'byte')} in no frame` : ''}.`,
  nothing: 'Nothing has been heard yet.',
  noisy: 'Much of it belongs to no frame: the speed or the format may be different.',
  counts: 'What was heard, by unit and function',
  columns: {
    unit: 'Unit',
    functionCode: 'Function',
    requests: 'Requests',
    replies: 'Replies',
    exceptions: 'Exceptions',
    unanswered: 'No reply',
    wrong: 'Wrong',
  },
  unit: (unit: number) => `${unit} (0x${byteHex(unit)})`,
  functionName: (got: number) => `${code(got)} ${describeFunction(got, 'request').name}`,
};
