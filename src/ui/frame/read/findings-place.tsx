import { Slot } from '../../parts/slot.tsx';
import { isAsked } from './asked.ts';
import type { FindingsProps } from './findings.tsx';

const load = () => import('./findings.tsx').then((findings) => findings.load());

/** Where findings stand, which come when they are first asked for. */
export const FindingsPlace = ({ draft, frame }: FindingsProps) =>
  frame && isAsked(frame.reading, frame.bytes) && <Slot part={load} with={{ draft, frame }} />;
