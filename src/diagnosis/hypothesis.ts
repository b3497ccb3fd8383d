import type { Case } from './case.ts';
import type { FindingCode, Offer } from './finding.ts';

/** One way in which bytes come about, and the traces it leaves in them. */
export interface Hypothesis {
  readonly codes: readonly FindingCode[];
  offer(item: Case): readonly Offer[];
}
