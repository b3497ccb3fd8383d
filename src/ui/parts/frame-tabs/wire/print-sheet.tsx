import { useEffect } from 'preact/hooks';
import { toHex } from '../../../../modbus/index.ts';
import { exchangeOf, sceneOf, verdictOf, viewOf, type WireProps } from '../../../../workbench/index.ts';
import { useExplained } from '../../current-frame.ts';
import { Explanation } from '../../explanation/explanation.tsx';
import { line } from '../../line.ts';
import { page } from '../../store.ts';
import { useWords } from '../../words.ts';
import { wireSettings } from './line-settings.tsx';
import { usePictureTexts } from './picture/drawing.ts';
import { GUTTER, Picture } from './picture/picture.tsx';
import './print-sheet.css';
import './wire.css';

interface SheetProps {
  /** Counts how often printing was asked for; below 0 the browser prints by itself. */
  readonly asked: number;
}

/** Pixels that the picture is wide, about those of a sheet. */
const WIDTH = 680;
const MICRO = 1000;

/** What is printed of the current frame: its bytes, what they mean, the line, and the link. It is not on the screen. */
export function PrintSheet({ asked }: SheetProps) {
  const { tabs } = useWords('page').page;
  const { strip, views } = useWords('page');
  const explained = useExplained();
  const { draft, frame } = page.shown.value;
  useEffect(() => {
    if (asked > 0) print();
  }, [asked]);
  if (frame === undefined) return null;
  const { reading, bytes } = frame;
  const isSerial = reading.transport === 'rtu' || reading.transport === 'ascii';
  const text =
    reading.transport === 'ascii' ? new TextDecoder().decode(bytes) : toHex(bytes).replace(/..(?=.)/g, '$& ');
  return (
    <section class="print-sheet" aria-label={views.print}>
      <h2>
        {strip.verdict(verdictOf(reading), reading)} <small>{strip.kindAndSize(reading, bytes.length)}</small>
      </h2>
      <p class="mono sheet-bytes">{text}</p>
      <Explanation of={explained} />
      {isSerial && (
        <>
          <h2>
            {tabs.names.wire} <small>{views.lineName(line.setting.value)}</small>
          </h2>
          <Waveform draft={draft} frame={frame} />
        </>
      )}
      <p class="sheet-link">{`${location.origin}${location.pathname}#${page.link.value}`}</p>
    </section>
  );
}

/** The frame on the line as it is set, as wide as the sheet. */
function Waveform(shown: WireProps) {
  const texts = usePictureTexts();
  const { level, delay } = wireSettings.value;
  const scene = sceneOf(exchangeOf(shown), { serial: line.setting.value, delay: delay * MICRO, gap: undefined });
  const view = viewOf(scene, { width: WIDTH - GUTTER, px: 0, from: 0 }, 'frame');
  return <Picture scene={scene} kind={level} view={view} words={texts} />;
}
