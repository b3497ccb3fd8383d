import { defaultRules, defaultSettings, type LinkSettings, type TransactionRules } from '../../bus/index.ts';
import { KeptChoice } from '../../store/index.ts';
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
import { storage } from '../parts/store.ts';

/** How a port is opened, as chosen last. */
export const settingsMemory = new KeptChoice<LinkSettings>(storage, 'bus-settings', defaultSettings, readLinkSettings);

/** How transactions are carried out, as chosen last. */
export const rulesMemory = new KeptChoice<TransactionRules>(storage, 'bus-rules', defaultRules, readRules);

/** How is polled, as chosen last. */
export const pollMemory = new KeptChoice<PollSettings>(storage, 'poll', defaultPoll, readPollSettings);

/** How is scanned, as chosen last. */
export const scanMemory = new KeptChoice<ScanSettings>(storage, 'scan', defaultScan, readScanSettings);

/** How fast the virtual bus goes, as chosen last. */
export const paceMemory = new KeptChoice<Pace>(storage, 'virtual-pace', 'line', readPace);
