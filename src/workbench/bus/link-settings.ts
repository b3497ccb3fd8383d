import { defaultRules, defaultSettings, type LinkSettings, type TransactionRules } from '../../bus/index.ts';
import type { SerialLine } from '../../modbus/index.ts';
import { LEAST_BAUD, MOST_BAUD } from '../line/line-setting.ts';
import { type Decoder, oneOf, record, whole } from '../stored.ts';

/** The least and the most of each number that a port is opened with. */
export const linkLimits = {
  baud: [LEAST_BAUD, MOST_BAUD],
  bufferSize: [1, 16_777_216],
} as const;

/** The least and the most of each number by which transactions are carried out. */
export const ruleLimits = {
  timeout: [1, 60_000],
  retries: [0, 10],
  turnaround: [0, 10_000],
  patience: [1, 10_000],
} as const;

/** What a port is opened with besides the line's own setting. */
export type PortSettings = Omit<LinkSettings, keyof SerialLine>;

const { flowControl, bufferSize } = defaultSettings;
export const firstPort: PortSettings = { flowControl, bufferSize };

/** What a port is opened with, out of storage. */
export const readPortSettings = record<PortSettings>(
  { flowControl: oneOf(['none', 'hardware']), bufferSize: whole(...linkLimits.bufferSize) },
  firstPort,
);

/** The silence before a request is what the speed asks for: nobody can set it, so that none is taken from storage. */
const noGap: Decoder<undefined> = () => undefined;

/** Only the session knows that a line has no late replies. */
const notPunctual: Decoder<boolean> = () => undefined;

/** How transactions are carried out, out of storage. */
export const readRules = record<TransactionRules>(
  {
    transport: oneOf(['rtu', 'ascii']),
    timeout: whole(...ruleLimits.timeout),
    retries: whole(...ruleLimits.retries),
    gap: noGap,
    turnaround: whole(...ruleLimits.turnaround),
    echo: oneOf(['auto', 'on', 'off']),
    quiet: oneOf<boolean>([true, false]),
    punctual: notPunctual,
    patience: whole(...ruleLimits.patience),
  },
  defaultRules,
);
