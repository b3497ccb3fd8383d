import type { Finding, FindingCode } from '../../diagnosis/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { addressIn, byte } from './common.ts';

/** What is said of a finding: what it is, why it is so, and what to do about it. */
export interface FindingWords {
  readonly title: string;
  readonly why: string;
  readonly todo: string;
  /** The cause in one sentence, where the title alone is not one. */
  readonly cause?: string;
}

/** The words for some of the findings. */
export type WordsFor<C extends FindingCode> = {
  readonly [K in C]: (finding: Extract<Finding, { code: K }>) => FindingWords;
};

/** A CRC's two bytes as they are sent, low byte first. */
export const wire = (crc: number): string => formatBytes(Uint8Array.of(crc & 0xff, crc >>> 8));

/** A unit identifier in both ways people write it. */
export const unit = (value: number): string => `${value} (${byte(value)})`;

/** An address in both ways people write it. */
export const addressOf = addressIn;
