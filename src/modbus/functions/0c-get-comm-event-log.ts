import { layout } from '../field.ts';
import { choice, count, lengthOf, u16 } from '../fields/number.ts';
import { octets } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';
import { COMM_STATUS } from './0b-get-comm-event-counter.ts';

/** Status, event count and message count come before the events. */
const BEFORE_EVENTS = 6;
const MOST_EVENTS = 64;

export const getCommEventLog = defineFunction({
  code: 0x0c,
  name: 'Get Comm Event Log',
  section: 'AP 6.10',
  group: 'diagnostics',
  access: 'reads',
  probe: {},
  serialOnly: true,
  request: layout([]),
  response: layout([
    count('byteCount', {
      least: BEFORE_EVENTS,
      most: BEFORE_EVENTS + MOST_EVENTS,
      derive: lengthOf('events', (events) => BEFORE_EVENTS + events),
    }),
    choice('status', COMM_STATUS, { width: 2 }),
    u16('eventCount'),
    u16('messageCount'),
    octets('events', ({ count }) => Math.max(0, count - BEFORE_EVENTS)),
  ]),
});
