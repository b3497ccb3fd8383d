import { KeptChoice } from '../../store/index.ts';
import {
  defaultPoll,
  defaultScan,
  type PollSettings,
  readPollSettings,
  readScanSettings,
  type ScanSettings,
} from '../../workbench/index.ts';
import { storage } from '../parts/store.ts';

/** How is polled, as chosen last. */
export const pollMemory = new KeptChoice<PollSettings>(storage, 'poll', defaultPoll, readPollSettings);

/** How is scanned, as chosen last. */
export const scanMemory = new KeptChoice<ScanSettings>(storage, 'scan', defaultScan, readScanSettings);
