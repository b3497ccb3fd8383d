import { type SeenFault, seenFaults, type Timeline, type TimelineBin } from '../../../workbench/index.ts';
import { UPlot } from '../../parts/uplot.ts';
import { faultMarks } from './fault-marks.tsx';

const HEIGHT = 220;
/** The height of the line of each kind of fault, above the reply times. */
const LANE = 16;
const SECOND = 1_000_000;
/** Pixels of the screen that are no drag yet. */
const STILL = 4;
const COLOURS = ['--soft', '--line', '--accent', ...seenFaults.map((kind) => faultMarks[kind].colour)];

interface ChartParts {
  readonly place: HTMLElement;
  readonly timeText: (time: number) => string;
  readonly duration: (time: number) => string;
  /** The pointer is at a time; `undefined` if it is nowhere. */
  readonly onPoint: (time: number | undefined) => void;
  readonly onClick: (time: number) => void;
  /** A part of the time was dragged over. */
  readonly onSelect: (from: number, to: number) => void;
}

/** The kinds of fault that a timeline has. */
export const kindsIn = ({ bins }: Timeline): readonly SeenFault[] =>
  seenFaults.filter((kind) => bins.some(({ faults }) => faults.some((fault) => fault.kind === kind)));

/** Draws a timeline: of each column the shortest to the longest reply time, and above them its faults, a line for each kind. */
export class TimelineChart {
  readonly #plot: UPlot;
  readonly #parts: ChartParts;
  readonly #stop = new AbortController();
  #timeline: Timeline;
  #kinds: readonly SeenFault[];
  #colours: ReadonlyMap<string, string>;
  #pointed: number | undefined;

  constructor(parts: ChartParts, timeline: Timeline) {
    this.#parts = parts;
    this.#timeline = timeline;
    this.#kinds = kindsIn(timeline);
    this.#colours = coloursIn(parts.place);
    const { place, timeText, duration } = parts;
    const colour = (name: string) => () => this.#colour(name);
    const axis = { stroke: colour('--soft'), grid: { stroke: colour('--line'), width: 1 }, ticks: { show: false } };
    this.#plot = new UPlot(
      {
        width: place.clientWidth,
        height: HEIGHT + LANE * this.#kinds.length,
        padding: [() => LANE * this.#kinds.length + 6, 12, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: false, dist: STILL } },
        scales: {
          x: { time: false, range: () => this.#range() },
          y: { range: (_, _least, most) => [0, Math.max(1, 1.08 * (most ?? 1))] },
        },
        axes: [
          {
            ...axis,
            space: 110,
            size: 34,
            gap: 12,
            values: (_, splits) => splits.map((split) => timeText(split * SECOND)),
          },
          { ...axis, size: 64, values: (_, splits) => splits.map(duration) },
        ],
        series: [{}, { paths: () => null, points: { show: false } }],
        hooks: {
          draw: [(plot) => this.#draw(plot)],
          setCursor: [({ cursor: { left = -1 } }) => parts.onPoint(left < 0 ? undefined : this.#timeAt(left))],
          setSelect: [({ select: { left, width } }) => this.#select(left, width)],
        },
      },
      this.#data(),
      place,
    );
    const { signal } = this.#stop;
    let down = 0;
    this.#plot.over.addEventListener('mousedown', ({ clientX }) => (down = clientX), { signal });
    this.#plot.over.addEventListener(
      'click',
      ({ clientX, offsetX }) => Math.abs(clientX - down) < STILL && parts.onClick(this.#timeAt(offsetX)),
      { signal },
    );
    const observer = new ResizeObserver(() => this.#size());
    observer.observe(place);
    signal.addEventListener('abort', () => observer.disconnect());
    const recolour = () => {
      this.#colours = coloursIn(place);
      this.#plot.redraw(false);
    };
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolour, { signal });
  }

  show(timeline: Timeline): void {
    this.#timeline = timeline;
    this.#kinds = kindsIn(timeline);
    this.#size();
    this.#plot.setData(this.#data());
  }

  /** Marks columns, or the one where the keys are. */
  mark(from: TimelineBin | undefined, to = from): void {
    const place = ({ from }: TimelineBin) => this.#plot.valToPos(from / SECOND, 'x');
    this.#pointed = from?.from;
    const [left, right] = from && to ? [place(from), place(to)].sort((one, other) => one - other) : [0, 0];
    const { height } = this.#plot.over.getBoundingClientRect();
    this.#plot.setSelect({ left: left ?? 0, width: (right ?? 0) - (left ?? 0), top: 0, height }, false);
    this.#plot.redraw(false);
  }

  end(): void {
    this.#stop.abort();
    this.#plot.destroy();
  }

  #colour(name: string): string {
    return this.#colours.get(name) ?? 'gray';
  }

  #size(): void {
    const { clientWidth: width } = this.#parts.place;
    if (width > 0) this.#plot.setSize({ width, height: HEIGHT + LANE * this.#kinds.length });
  }

  #timeAt(left: number): number {
    return this.#plot.posToVal(left, 'x') * SECOND;
  }

  #select(left: number, width: number): void {
    if (width < STILL) return;
    this.#plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    this.#parts.onSelect(this.#timeAt(left), this.#timeAt(left + width));
  }

  #data(): UPlot.AlignedData {
    const { bins } = this.#timeline;
    return [bins.map(({ from }) => from / SECOND), bins.map(({ maximum }) => maximum ?? null)];
  }

  #range(): [number, number] {
    const { from, to } = this.#timeline;
    const margin = Math.max(0.01 * (to - from), 1000);
    return [(from - margin) / SECOND, (to + margin) / SECOND];
  }

  #draw({ ctx, bbox, valToPos }: UPlot): void {
    const ratio = devicePixelRatio;
    const x = ({ from, to }: TimelineBin) => Math.round(valToPos((from + to) / 2 / SECOND, 'x', true));
    ctx.save();
    ctx.lineWidth = 2 * ratio;
    ctx.strokeStyle = this.#colour('--accent');
    ctx.beginPath();
    for (const bin of this.#timeline.bins) {
      if (bin.minimum === undefined || bin.maximum === undefined) continue;
      const [low, high] = [valToPos(bin.minimum, 'y', true), valToPos(bin.maximum, 'y', true)];
      // A single time is a dot.
      ctx.moveTo(x(bin), Math.max(low, high + 2 * ratio));
      ctx.lineTo(x(bin), high - ratio);
    }
    ctx.stroke();
    for (const [lane, kind] of this.#kinds.entries()) {
      const { colour, path, filled } = faultMarks[kind];
      const y = bbox.top - (this.#kinds.length - lane - 0.5) * LANE * ratio;
      const shape = new Path2D(path);
      ctx.strokeStyle = this.#colour(colour);
      ctx.fillStyle = this.#colour(colour);
      for (const bin of this.#timeline.bins) {
        if (!bin.faults.some((fault) => fault.kind === kind)) continue;
        ctx.setTransform(ratio, 0, 0, ratio, x(bin), y);
        ctx.lineWidth = 1.6;
        if (filled) ctx.fill(shape);
        ctx.stroke(shape);
      }
      ctx.setTransform(1, 0, 0, 1, 0, 0);
    }
    if (this.#pointed !== undefined) {
      const at = Math.round(valToPos(this.#pointed / SECOND, 'x', true));
      ctx.strokeStyle = this.#colour('--soft');
      ctx.lineWidth = ratio;
      ctx.beginPath();
      ctx.moveTo(at, bbox.top - this.#kinds.length * LANE * ratio);
      ctx.lineTo(at, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  }
}

/** The colours in the page's present scheme: a canvas knows no custom properties. */
function coloursIn(place: HTMLElement): ReadonlyMap<string, string> {
  const probe = document.createElement('i');
  place.append(probe);
  const colours = COLOURS.map((name) => {
    probe.style.color = `var(${name})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return new Map(colours);
}
