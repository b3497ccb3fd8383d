import { computed, type ReadonlySignal, useSignalEffect } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Register } from '../../../devices/index.ts';
import type { ChartData } from '../../../workbench/index.ts';
import { UPlot } from '../../parts/uplot.ts';
import { useWords } from '../../parts/words.ts';

/** A line of the chart. */
export interface Line {
  readonly index: number;
  readonly name: string;
  readonly register: Register;
  /** A custom property of the page's colours. */
  readonly colour: string;
  readonly dash: readonly number[];
}

/** What the chart shows. */
interface Shown {
  readonly data: ChartData;
  /** The time of the last round, in seconds since 1970. */
  readonly end: number;
  /** Seconds; 0 shows everything. */
  readonly window: number;
}

interface ChartProps {
  readonly lines: readonly Line[];
  readonly shown: ReadonlySignal<Shown>;
}

const HEIGHT = 260;
/** The chart is never of less, in seconds. */
const LEAST_SPAN = 5;
const AXES = ['--soft', '--line'] as const;

/** Numbers over time, and their values where the pointer is. */
export function Chart({ lines, shown }: ChartProps) {
  const words = useWords('poll');
  const root = useRef<HTMLDivElement>(null);
  const pointed = useRef<HTMLParagraphElement>(null);
  const chart = useRef<UPlot>(null);
  const label = useMemo(() => {
    const names = lines.map(({ name }) => name);
    return computed(() => {
      const [times] = shown.value.data;
      return words.chartIs(names, 1000 * ((times.at(-1) ?? 0) - (times[0] ?? 0)));
    });
  }, [lines, shown, words]);

  useEffect(() => {
    const { current: place } = root;
    if (place === null) return;
    /** Says the values where the pointer is. Drawing the panel again would cost each move. */
    const point = ({ cursor: { idx }, data }: UPlot) => {
      const time = idx == null ? undefined : data[0][idx];
      const values = lines.map(({ name, register }, at) => {
        const value = idx == null ? undefined : data[at + 1]?.[idx];
        return `${name} ${value == null ? words.missing : words.inUnit(value, register)}`;
      });
      const text =
        time === undefined ? words.pointHint : `${new Date(1000 * time).toLocaleTimeString()}: ${values.join(', ')}`;
      if (pointed.current) pointed.current.textContent = text;
    };
    /** The end is the last round. While there is less than was chosen, the beginning is the first. */
    const range = (_: UPlot, least: number | null, most: number | null): [number, number] => {
      const { end, window } = shown.peek();
      const [from, to] = [least ?? end, most ?? end];
      return [Math.min(window > 0 ? Math.max(from, end - window) : from, to - LEAST_SPAN), to];
    };
    let colours = coloursIn(place, lines);
    const colour = (name: string) => () => colours.get(name) ?? 'gray';
    const axis = { stroke: colour('--soft'), grid: { stroke: colour('--line'), width: 1 }, ticks: { show: false } };
    const made = new UPlot(
      {
        width: place.clientWidth,
        height: HEIGHT,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, points: { show: false } },
        scales: { x: { time: true, range } },
        axes: [
          { ...axis, space: 70, values: '{HH}:{mm}:{ss}' },
          { ...axis, size: 60, values: (_, splits) => splits.map(shortly) },
        ],
        series: [
          {},
          ...lines.map(({ name, colour: stroke, dash }) => ({
            label: name,
            stroke: colour(stroke),
            width: 2,
            dash: [...dash],
            // One or two rounds make no line yet.
            points: { show: ({ data }: UPlot) => data[0].length < 3 },
          })),
        ],
        hooks: { setCursor: [point] },
      },
      shown.peek().data,
      place,
    );
    chart.current = made;
    const observer = new ResizeObserver(() => made.setSize({ width: place.clientWidth, height: HEIGHT }));
    observer.observe(place);
    const scheme = matchMedia('(prefers-color-scheme: dark)');
    const recolour = () => {
      colours = coloursIn(place, lines);
      made.redraw(false);
    };
    scheme.addEventListener('change', recolour);
    return () => {
      observer.disconnect();
      scheme.removeEventListener('change', recolour);
      made.destroy();
    };
  }, [lines, shown, words]);

  // The session tells what it has read every 60 ms at most: the chart is not drawn more often.
  useSignalEffect(() => {
    const { data } = shown.value;
    chart.current?.setData(data);
  });

  return (
    <>
      <ul class="poll-legend in-row">
        {lines.map(({ index, name, register, colour, dash }) => (
          <li key={index}>
            <svg width="34" height="8" aria-hidden="true">
              <line
                x1="0"
                y1="4"
                x2="34"
                y2="4"
                stroke={`var(${colour})`}
                stroke-width="2"
                stroke-dasharray={dash.join(' ')}
              />
            </svg>{' '}
            {name}
            {register.unit && ` (${register.unit})`}
          </li>
        ))}
      </ul>
      <div ref={root} class="poll-plot" role="img" aria-label={label} />
      <p ref={pointed} class="said poll-point" aria-hidden="true">
        {words.pointHint}
      </p>
    </>
  );
}

/** The colours in the page's present scheme: a canvas knows no custom properties. */
function coloursIn(place: HTMLElement, lines: readonly Line[]): ReadonlyMap<string, string> {
  const probe = document.createElement('i');
  place.append(probe);
  const names = [...AXES, ...lines.map(({ colour }) => colour)];
  const colours = names.map((name) => {
    probe.style.color = `var(${name})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return new Map(colours);
}

/** A number beside the axis. */
const shortly = (value: number): string =>
  Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-3)
    ? value.toExponential(1)
    : String(Number(value.toPrecision(6)));
