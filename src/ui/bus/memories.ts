import { defaultRules, defaultSettings, type LinkSettings, type TransactionRules } from '../../bus/index.ts';
import {
  defaultPoll,
  defaultScan,
  type Pace,
  type PollSettings,
  readLinkSettings,
  readPace,
  readPollSettings,
  readRules,
  readScanSettings,
  type ScanSettings,
} from '../../workbench/index.ts';
import { Remembered } from '../state/remembered.ts';

/** How a port is opened, as chosen last. */
export const settingsMemory = new Remembered<LinkSettings>('bus-settings', defaultSettings, readLinkSettings);

/** How transactions are carried out, as chosen last. */
export const rulesMemory = new Remembered<TransactionRules>('bus-rules', defaultRules, readRules);

/** How is polled, as chosen last. */
export const pollMemory = new Remembered<PollSettings>('poll', defaultPoll, readPollSettings);

/** How is scanned, as chosen last. */
export const scanMemory = new Remembered<ScanSettings>('scan', defaultScan, readScanSettings);

/** How fast the virtual bus goes, as chosen last. */
export const paceMemory = new Remembered<Pace>('virtual-pace', 'line', readPace);
