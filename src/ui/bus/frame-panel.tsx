import { useEffect, useRef } from 'preact/hooks';
import type { BusView } from '../../store/index.ts';
import { FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { page } from '../parts/store.ts';
import { CurrentStrip } from '../parts/strip/current-strip.tsx';
import { RowAbout } from '../parts/trace-rows/row-about.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { busTrace, rowChosen } from './bus.ts';

/** The current frame, which a row of the log becomes when it is chosen: its bytes, and all that can be said of it. */
export function FramePanel({ view }: ViewProps<BusView>) {
  const panel = useRef<HTMLDivElement>(null);
  const isShown = view.shown.value.tab === 'frame';
  useEffect(() => {
    const { current } = panel;
    if (!isShown || current === null) return;
    const { top } = current.getBoundingClientRect();
    // On a narrow page the log is below it.
    if (top < 0 || top > innerHeight) current.scrollIntoView();
  }, [isShown, rowChosen.value]);
  return (
    <div ref={panel}>
      <RowAbout of={busTrace} />
      <CurrentStrip />
      <FrameTabs of={page.shown} chosen={page.tab} onChoose={page.openTab} />
    </div>
  );
}
