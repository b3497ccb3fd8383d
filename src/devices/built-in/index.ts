import type { Profile } from '../profile.ts';
import { sdm120, sdm630 } from './eastron.ts';
import { enron } from './enron.ts';
import { i8xx7 } from './i-8xx7.ts';
import { modicon984 } from './modicon-984.ts';
import { s7200 } from './s7-200.ts';
import { sunSpecInverter } from './sunspec-inverter.ts';
import { wegDrive } from './weg-drive.ts';

/** The profiles that are here from the start. */
export const builtInProfiles: readonly Profile[] = [
  wegDrive,
  s7200,
  i8xx7,
  modicon984,
  enron,
  sdm120,
  sdm630,
  sunSpecInverter,
];
