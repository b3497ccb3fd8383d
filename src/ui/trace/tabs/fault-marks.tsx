import type { SeenFault } from '../../../workbench/index.ts';

/** How a kind of fault is drawn: its colour in the page, and a shape around 0,0. */
interface FaultMark {
  /** A custom property of the page's colours. */
  readonly colour: string;
  readonly path: string;
  readonly filled: boolean;
}

/** No two kinds have the same shape. */
export const faultMarks: Readonly<Record<SeenFault, FaultMark>> = {
  exception: { colour: '--warn', path: 'M0-5 5 4H-5Z', filled: true },
  checksum: { colour: '--check', path: 'M-4-4 4 4M4-4-4 4', filled: false },
  'no-reply': { colour: '--bad', path: 'M-4 0A4 4 0 0 0 4 0A4 4 0 0 0-4 0Z', filled: false },
  late: { colour: '--value', path: 'M-4-5 4 0-4 5Z', filled: true },
  doubtful: { colour: '--count', path: 'M0-5 5 0 0 5-5 0Z', filled: false },
  mismatch: { colour: '--function', path: 'M-4-4H4V4H-4Z', filled: true },
  broken: { colour: '--bad', path: 'M-5 3-2-4 1 4 5-4', filled: false },
  stray: { colour: '--unit', path: 'M-5 0H5M0-5V5', filled: false },
  timing: { colour: '--accent', path: 'M-2-5V5M2-5V5', filled: false },
  'no-frame': { colour: '--bad', path: 'M-5-3H5M-5 3H5', filled: false },
};

/** The mark of a kind, beside its name. */
export const FaultMarkPicture = ({ kind }: { readonly kind: SeenFault }) => {
  const { colour, path, filled } = faultMarks[kind];
  return (
    <svg width="14" height="14" viewBox="-7 -7 14 14" aria-hidden="true">
      <path d={path} fill={filled ? `var(${colour})` : 'none'} stroke={`var(${colour})`} stroke-width="1.6" />
    </svg>
  );
};
