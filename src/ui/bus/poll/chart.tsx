import { Component, createRef } from 'preact';
import UPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Register } from '../../../devices/index.ts';
import type { ChartData } from '../../../workbench/index.ts';
import { pollWords as words } from './poll-words.ts';

/** A line of the chart. */
export interface Line {
  readonly index: number;
  readonly name: string;
  readonly register: Register;
  /** A custom property of the page's colours. */
  readonly colour: string;
  readonly dash: readonly number[];
}

interface ChartProps {
  readonly lines: readonly Line[];
  readonly data: ChartData;
  /** What the chart is, for those who do not see it. */
  readonly label: string;
  /** The end of what is shown, in seconds since 1970, and its length; 0 shows all. */
  readonly end: number;
  readonly window: number;
}

const HEIGHT = 260;
/** The chart is never of less, in seconds. */
const LEAST_SPAN = 5;
const AXES = ['--soft', '--line'] as const;

/** Numbers over time, and what they are where one points. Other lines are another chart: give it another key. */
export class Chart extends Component<ChartProps> {
  private readonly root = createRef<HTMLDivElement>();
  private readonly read = createRef<HTMLParagraphElement>();
  private chart: UPlot | undefined;
  private observer: ResizeObserver | undefined;
  private colours: ReadonlyMap<string, string> = new Map();
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');

  override componentDidMount() {
    const { current: root } = this.root;
    if (root === null) return;
    this.takeColours();
    const { lines, data } = this.props;
    const colour = (name: string) => () => this.colours.get(name) ?? 'gray';
    const axis = { stroke: colour('--soft'), grid: { stroke: colour('--line'), width: 1 }, ticks: { show: false } };
    this.chart = new UPlot(
      {
        width: root.clientWidth,
        height: HEIGHT,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, points: { show: false } },
        scales: { x: { time: true, range: this.range } },
        axes: [
          { ...axis, space: 70, values: '{HH}:{mm}:{ss}' },
          { ...axis, size: 60, values: (_, splits) => splits.map(shortly) },
        ],
        series: [
          {},
          ...lines.map(({ name, colour: own, dash }) => ({
            label: name,
            stroke: colour(own),
            width: 2,
            dash: [...dash],
            // One or two rounds are no line yet.
            points: { show: ({ data: shown }: UPlot) => shown[0].length < 3 },
          })),
        ],
        hooks: { setCursor: [this.point] },
      },
      data,
      root,
    );
    this.observer = new ResizeObserver(() => this.chart?.setSize({ width: root.clientWidth, height: HEIGHT }));
    this.observer.observe(root);
    this.scheme.addEventListener('change', this.recolour);
  }

  override componentDidUpdate() {
    this.chart?.setData(this.props.data);
  }

  override componentWillUnmount() {
    this.observer?.disconnect();
    this.scheme.removeEventListener('change', this.recolour);
    this.chart?.destroy();
  }

  /** What is shown ends with the last round. While there is less than was chosen, it begins with the first. */
  private readonly range = (_: UPlot, least: number | null, most: number | null): [number, number] => {
    const { end, window } = this.props;
    const [from, to] = [least ?? end, most ?? end];
    return [Math.min(window > 0 ? Math.max(from, end - window) : from, to - LEAST_SPAN), to];
  };

  private readonly recolour = () => {
    this.takeColours();
    this.chart?.redraw(false);
  };

  /** The colours as they are in this scheme: a canvas knows no custom properties. */
  private takeColours() {
    const probe = document.createElement('i');
    this.root.current?.append(probe);
    const names = [...AXES, ...this.props.lines.map(({ colour }) => colour)];
    this.colours = new Map(
      names.map((name) => {
        probe.style.color = `var(${name})`;
        return [name, getComputedStyle(probe).color];
      }),
    );
    probe.remove();
  }

  /** Says what the lines are where the pointer is. Drawing the panel again for it would cost each move. */
  private readonly point = ({ cursor: { idx }, data }: UPlot) => {
    const { current: read } = this.read;
    if (read === null) return;
    const time = idx == null ? undefined : data[0][idx];
    if (idx == null || time === undefined) {
      read.textContent = words.pointHint;
      return;
    }
    const values = this.props.lines.map(({ name, register }, at) => {
      const value = data[at + 1]?.[idx];
      return `${name} ${value == null ? words.missing : words.inUnit(value, register)}`;
    });
    read.textContent = `${new Date(1000 * time).toLocaleTimeString()}: ${values.join(', ')}`;
  };

  render() {
    const { lines, label } = this.props;
    return (
      <>
        <ul class="poll-legend">
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
        <div ref={this.root} class="poll-plot" role="img" aria-label={label} />
        <p ref={this.read} class="said poll-point" aria-hidden="true">
          {words.pointHint}
        </p>
      </>
    );
  }
}

/** A number beside the axis. */
const shortly = (value: number): string =>
  Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-3)
    ? value.toExponential(1)
    : String(Number(value.toPrecision(6)));
