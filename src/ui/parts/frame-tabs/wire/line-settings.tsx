import type { SerialMode } from '../../../../modbus/index.ts';
import { Line } from '../../../../store/index.ts';
import { type LevelKind, levelKinds, readGapAt, readMilliseconds, readSpeed } from '../../../../workbench/index.ts';
import { NumberEntry } from '../../../kit/number-entry.tsx';
import { Segments } from '../../../kit/segments.tsx';
import { device } from '../../device/naming.ts';
import { storage } from '../../store.ts';
import { useWords } from '../../words.ts';
import { FormatChoice } from './format-choice.tsx';

/** The line on which this page draws frames. */
export const lineStore = new Line(storage, device);

interface GapSettings {
  /** The byte that a gap precedes. */
  readonly gapAt: number | undefined;
  /** Milliseconds. */
  readonly gapTime: number;
}

interface SettingsProps extends GapSettings {
  readonly mode: SerialMode;
  /** The number of the last byte, from 0. */
  readonly last: number;
  readonly onGap: (changed: Partial<GapSettings>) => void;
}

const SPEEDS = ['1200', '2400', '4800', '9600', '19200', '38400', '57600', '115200'];
const LEVELS = Object.keys(levelKinds) as LevelKind[];

/** How the line is set, when the device answers, and a gap in the frame to try out. */
export function LineSettings({ mode, last, gapAt, gapTime, onGap }: SettingsProps) {
  const words = useWords('wire');
  const { serial, level, delay } = lineStore.choice(mode);
  const set = (changed: Parameters<typeof lineStore.set>[1]) => lineStore.set(mode, changed);
  return (
    <div class="wire-settings field-grid">
      <NumberEntry
        id="wire-speed"
        label={words.speed}
        value={String(serial.baud)}
        usual={SPEEDS}
        read={readSpeed}
        wrong={words.notASpeed}
        onValue={(baud) => set({ serial: { ...serial, baud } })}
      />
      <FormatChoice
        id="wire-format"
        label={words.format}
        value={serial}
        onChoose={(format) => set({ serial: { ...serial, ...format } })}
      />
      <Segments
        label={words.levels}
        value={level}
        options={LEVELS.map((value) => ({ value, name: words.levelKinds[value] }))}
        onChoose={(kind) => set({ level: kind })}
      />
      <NumberEntry
        id="wire-delay"
        label={words.delay}
        value={String(delay)}
        read={readMilliseconds}
        wrong={words.notADelay}
        onValue={(time) => set({ delay: time })}
      />
      {last > 0 && (
        <>
          <NumberEntry
            id="wire-gap"
            label={words.gapAt}
            value={gapAt === undefined ? '' : String(gapAt)}
            hint={words.gapAtHint(last)}
            read={(text) => readGapAt(text, last)}
            wrong={words.notAGapAt(last)}
            onValue={onGap}
          />
          <NumberEntry
            id="wire-gap-time"
            label={words.gapTime}
            value={String(gapTime)}
            read={readMilliseconds}
            wrong={words.notADelay}
            onValue={(time) => onGap({ gapTime: time })}
          />
        </>
      )}
    </div>
  );
}
