import { type Fault, type FaultKind, faultKinds, type TraceSummary } from '../../trace/index.ts';

/** What is wrong with a row, by kind: a fault of a frame, or that the row is not a frame. */
export type SeenFault = FaultKind | 'no-frame';
export const seenFaults: readonly SeenFault[] = [...faultKinds, 'no-frame'];

/** Noise is a broken frame to a trace, which has records only. */
export const seenFault = ({ kind, code }: Pick<Fault, 'kind' | 'code'>): SeenFault =>
  kind === 'broken' && code === 'noise' ? 'no-frame' : kind;

/** How often each kind of fault is seen in a trace, of which so many records are in no frame; kinds that are not seen are left out. */
export const seenCounts = ({ faults }: Pick<TraceSummary, 'faults'>, pieces: number): ReadonlyMap<SeenFault, number> =>
  new Map(
    seenFaults
      .map((kind): readonly [SeenFault, number] => {
        if (kind === 'no-frame') return [kind, pieces];
        return [kind, faults[kind] - (kind === 'broken' ? pieces : 0)];
      })
      .filter(([, count]) => count > 0),
  );

/** Faults of a line or a device that answers as it should, but not as was hoped. */
const MILD: ReadonlySet<SeenFault> = new Set<SeenFault>(['exception', 'late', 'doubtful', 'timing']);

/** How grave a fault is. */
export const traceSeverity = (kind: SeenFault): 'error' | 'warning' => (MILD.has(kind) ? 'warning' : 'error');
