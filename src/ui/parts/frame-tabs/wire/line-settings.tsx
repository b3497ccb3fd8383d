import { KeptChoice } from '../../../../store/index.ts';
import {
  firstWire,
  type LevelKind,
  levelKinds,
  readGapAt,
  readMilliseconds,
  readSpeed,
  storedWire,
  type WireSettings,
} from '../../../../workbench/index.ts';
import { NumberEntry } from '../../../kit/number-entry.tsx';
import { Segments } from '../../../kit/segments.tsx';
import { line } from '../../line.ts';
import { storage } from '../../store.ts';
import { useWords } from '../../words.ts';
import { FormatChoice } from './format-choice.tsx';

/** How this page draws frames, besides the setting of the line. */
export const wireSettings = new KeptChoice<WireSettings>(storage, 'wire', firstWire, storedWire);

interface GapSettings {
  /** The byte that a gap precedes. */
  readonly gapAt: number | undefined;
  /** Milliseconds. */
  readonly gapTime: number;
}

interface SettingsProps extends GapSettings {
  /** The number of the last byte, from 0. */
  readonly last: number;
  readonly onGap: (changed: Partial<GapSettings>) => void;
}

const SPEEDS = ['1200', '2400', '4800', '9600', '19200', '38400', '57600', '115200'];
const LEVELS = Object.keys(levelKinds) as LevelKind[];

/** How the line is set, when the device answers, and a gap in the frame to try out. */
export function LineSettings({ last, gapAt, gapTime, onGap }: SettingsProps) {
  const words = useWords('wire');
  const serial = line.setting.value;
  const { level, delay } = wireSettings.value;
  const set = (changed: Partial<WireSettings>) => {
    wireSettings.value = { ...wireSettings.value, ...changed };
  };
  return (
    <div class="wire-settings field-grid">
      <NumberEntry
        id="wire-speed"
        label={words.speed}
        value={String(serial.baud)}
        usual={SPEEDS}
        read={readSpeed}
        wrong={words.notASpeed}
        onValue={(baud) => line.set({ baud })}
      />
      <FormatChoice id="wire-format" label={words.format} value={serial} onChoose={line.set} />
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
