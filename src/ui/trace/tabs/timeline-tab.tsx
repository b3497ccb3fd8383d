import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { dictionary } from '../../../modbus/index.ts';
import {
  binNear,
  filterOfAllTimes,
  filterOfTimes,
  filtersTimes,
  type SeenFault,
  type Timeline,
  type TimelineBin,
} from '../../../workbench/index.ts';
import { Fold } from '../../kit/fold.tsx';
import { Table } from '../../kit/table.tsx';
import { timeKind, timeText } from '../../parts/trace-rows/row-time.ts';
import { useWords } from '../../parts/words.ts';
import { FaultMarkPicture } from './fault-marks.tsx';
import { kindsIn, TimelineChart } from './timeline-chart.ts';
import { Counting, type TraceTabProps, useSome } from './trace-tab.tsx';

/** Pixels of the screen that a column of the picture takes. */
const COLUMN = 3;

/** Reply times and faults of what the filter keeps. */
export function TimelineTab({ of, open, toRows }: TraceTabProps) {
  const words = useWords('trace').tabs;
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const width = root.current?.clientWidth ?? 0;
    if (open && width > 0) of.tabs.want({ kind: 'timeline', columns: width / COLUMN });
  }, [of, open]);
  const timeline = of.tabs.timeline.value;
  return (
    <div ref={root}>
      <div class="in-row trace-timeline-head">
        <Legend timeline={timeline} />
        {filtersTimes(of.filter.value) && (
          <button type="button" onClick={() => of.setFilter(filterOfAllTimes(of.filter.peek()))}>
            {words.timeline.showAll}
          </button>
        )}
      </div>
      {timeline === undefined ? <Counting /> : <Shown of={of} open={open} toRows={toRows} timeline={timeline} />}
    </div>
  );
}

/** The faults that the picture has, with their marks. */
function Legend({ timeline }: { readonly timeline: Timeline | undefined }) {
  const { timeline: words } = useWords('trace').tabs;
  if (timeline === undefined) return null;
  const faults = timeline.bins.flatMap((bin) => bin.faults);
  const countOf = (kind: SeenFault) => faults.reduce((sum, fault) => sum + (fault.kind === kind ? fault.count : 0), 0);
  return (
    <ul class="trace-legend in-row">
      {kindsIn(timeline).map((kind) => (
        <li key={kind}>
          <FaultMarkPicture kind={kind} /> {words.legend(kind, countOf(kind))}
        </li>
      ))}
    </ul>
  );
}

interface ShownProps extends TraceTabProps {
  readonly timeline: Timeline;
}

function Shown(props: ShownProps) {
  const { of, toRows, timeline } = props;
  const words = useWords('trace').tabs;
  const { bins, untimed, origin } = timeline;
  const text = (time: number) => timeText({ time, since: time - origin }, timeKind.value, of.state.value);
  const goTo = ({ row }: TimelineBin) => {
    of.choose(row);
    toRows();
  };
  if (bins.length === 0) return <p class="said">{untimed > 0 ? words.timeline.noTimes : words.nothing}</p>;
  return (
    <>
      <Picture {...props} text={text} goTo={goTo} />
      {untimed > 0 && <p class="said">{words.timeline.untimed(untimed)}</p>}
      <Fold summary={words.timeline.asTable}>{() => <Bins bins={bins} text={text} goTo={goTo} />}</Fold>
    </>
  );
}

interface OfBins {
  readonly text: (time: number) => string;
  readonly goTo: (bin: TimelineBin) => void;
}

/** The picture. By keys it is gone through column by column. */
function Picture({ of, timeline, text, goTo }: ShownProps & OfBins) {
  const trace = useWords('trace');
  const { timeline: words } = trace.tabs;
  const root = useRef<HTMLDivElement>(null);
  const chart = useRef<TimelineChart>(null);
  const said = useRef<HTMLParagraphElement>(null);
  const [at, setAt] = useState(0);
  const [from, setFrom] = useState<number>();
  const { bins } = timeline;
  const bin = bins[Math.min(at, bins.length - 1)];
  const begin = from === undefined ? undefined : bins[Math.min(from, bins.length - 1)];

  const say = (one: TimelineBin | undefined) => {
    if (said.current) said.current.textContent = one ? words.bin(text(one.from), one) : words.hint;
  };
  const zoom = (least: number, most: number) => {
    const state = of.state.peek();
    const clock = state.kind === 'open' && timeKind.peek() === 'clock' ? state.clock : undefined;
    of.setFilter(filterOfTimes(of.filter.peek(), timeline.origin, least, most, clock));
  };
  const near = (time: number) => bins[binNear(timeline, time) ?? -1];
  // What the chart calls is that of the last drawing.
  const acts = useRef({ say, zoom, near, goTo, text });
  acts.current = { say, zoom, near, goTo, text };

  useLayoutEffect(() => {
    const { current: place } = root;
    if (place === null) return;
    const made = new TimelineChart(
      {
        place,
        timeText: (time) => acts.current.text(time),
        duration: trace.duration,
        onPoint: (time) => acts.current.say(time === undefined ? undefined : acts.current.near(time)),
        onClick: (time) => {
          const found = acts.current.near(time);
          if (found) acts.current.goTo(found);
        },
        onSelect: (least, most) => acts.current.zoom(least, most),
      },
      timeline,
    );
    chart.current = made;
    return () => made.end();
  }, [trace]);
  useEffect(() => chart.current?.show(timeline), [timeline, timeKind.value]);

  const move = (next: number, extends_: boolean) => {
    const place = Math.max(0, Math.min(bins.length - 1, next));
    const start = extends_ ? (from ?? at) : undefined;
    setFrom(start);
    setAt(place);
    chart.current?.mark(bins[start ?? place], bins[place]);
    say(bins[place]);
  };
  const key = (event: KeyboardEvent) => {
    const page = Math.max(1, Math.round(bins.length / 10));
    const places = dictionary<number>({
      ArrowLeft: at - 1,
      ArrowRight: at + 1,
      PageUp: at - page,
      PageDown: at + page,
      Home: 0,
      End: bins.length - 1,
    });
    const next = places[event.key];
    if (next !== undefined) move(next, event.shiftKey);
    else if (event.key === 'Enter' && bin && begin) {
      const [first, last] = begin.from <= bin.from ? [begin, bin] : [bin, begin];
      setFrom(undefined);
      zoom(first.from, last.to);
    } else if (event.key === 'Enter' && bin) goTo(bin);
    else return;
    event.preventDefault();
  };
  const value = bin ? words.bin(text(bin.from), bin) : '';
  return (
    <>
      <div
        class="trace-plot"
        role="slider"
        tabIndex={0}
        aria-label={words.label}
        aria-valuemin={1}
        aria-valuemax={bins.length}
        aria-valuenow={Math.min(at, bins.length - 1) + 1}
        aria-valuetext={begin && bin ? `${value}. ${words.selected(text(begin.from), text(bin.to))}` : value}
        onKeyDown={key}
        onBlur={() => {
          setFrom(undefined);
          chart.current?.mark(undefined);
        }}
      >
        <div ref={root} aria-hidden="true" />
      </div>
      <p ref={said} class="said trace-point" aria-hidden="true">
        {words.hint}
      </p>
    </>
  );
}

/** The same as a table. */
function Bins({ bins, text, goTo }: OfBins & { readonly bins: readonly TimelineBin[] }) {
  const trace = useWords('trace');
  const { timeline: words } = trace.tabs;
  const { shown, more } = useSome(bins);
  const { columns } = words;
  const time = (value: number | undefined) => value !== undefined && trace.duration(value);
  return (
    <>
      <Table
        label={words.label}
        narrow="scroll"
        rows={shown}
        keyOf={({ from }) => from}
        columns={[
          {
            name: columns.time,
            cell: (bin) => (
              <button type="button" aria-label={words.goTo(text(bin.from))} onClick={() => goTo(bin)}>
                {text(bin.from)}
              </button>
            ),
          },
          { name: columns.exchanges, class: 'number', cell: ({ exchanges }) => exchanges },
          { name: columns.minimum, class: 'number', cell: ({ minimum }) => time(minimum) },
          { name: columns.maximum, class: 'number', cell: ({ maximum }) => time(maximum) },
          { name: columns.faults, cell: (bin) => words.faults(bin) },
        ]}
      />
      {more}
    </>
  );
}
