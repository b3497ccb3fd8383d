import { hexDigits } from '../../../modbus/index.ts';
import { counterNames } from '../counters.ts';
import type { Device } from '../device.ts';
import { ECHO, type Effect, handle, reply, SILENCE } from './handler.ts';

const word = (value: number) => hexDigits(value, 4);

type SubFunction = (device: Device, data: string) => Effect | number;

const CLEAR_LOG = 'FF00';

/** By sub-function of 08: what is done, or the number that is answered (AP 6.8.1). Those that are reserved are not here. */
const SUB_FUNCTIONS: Readonly<Record<number, SubFunction>> = {
  0: () => ECHO,
  1: ({ counters }, data) => {
    const { listenOnly } = counters;
    counters.restart(data === CLEAR_LOG);
    return listenOnly ? SILENCE : ECHO;
  },
  2: ({ counters }) => counters.diagnosticRegister,
  // The delimiter of ASCII frames stays as it is: this device accepts the change but still sends LF.
  3: () => ECHO,
  4: ({ counters }) => {
    counters.enterListenOnly();
    return SILENCE;
  },
  10: ({ counters }) => {
    counters.clear();
    return ECHO;
  },
  ...Object.fromEntries(
    Object.entries(counterNames).map(([code, name]) => [code, ({ counters }: Device) => counters.counts[name]]),
  ),
  20: ({ counters }) => {
    counters.counts.overruns = 0;
    return ECHO;
  },
};

/** The only sub-function that a device obeys in listen only mode (AP 6.8.1). */
export const RESTART = 0x01;

export const diagnose = handle(
  0x08,
  (device, { subFunction }, { fields }) => {
    const done = SUB_FUNCTIONS[subFunction]?.(device, fields['data'] as string) ?? SILENCE;
    return typeof done === 'number' ? reply({ subFunction, data: word(done) }) : done;
  },
  { knows: ({ fields }) => SUB_FUNCTIONS[fields['subFunction'] as number] !== undefined },
);

const BUSY = 0xffff;
const BYTE = 0xff;
const status = ({ busy }: Device) => (busy ? BUSY : 0);

export const exceptionStatus = handle(0x07, (device) => reply({ outputData: device.exceptionStatus & BYTE }));

export const eventCounter = handle(
  0x0b,
  (device) => reply({ status: status(device), eventCount: device.counters.eventCount }),
  { uncounted: true },
);

/** Its message count is what 08 0B answers (AP 6.10). */
export const eventLog = handle(
  0x0c,
  (device) => {
    const { eventCount, counts, events } = device.counters;
    return reply({ status: status(device), eventCount, messageCount: counts.busMessages, events });
  },
  { uncounted: true },
);
