import { useSignal } from '@preact/signals';
import { useRef, useState } from 'preact/hooks';
import {
  bitsPerCharacter,
  charactersTime,
  formatStanding,
  type SerialLine,
  type SerialMode,
} from '../../../../modbus/index.ts';
import {
  exchangeOf,
  gapEffectOf,
  type ReceiverKind,
  receivedOf,
  receiverFor,
  receiverLine,
  type Scene,
  type StripView,
  sceneOf,
  viewOfByte,
  type WireProps,
} from '../../../../workbench/index.ts';
import { Fold } from '../../../kit/fold.tsx';
import { line } from '../../line.ts';
import { useWords } from '../../words.ts';
import { BitTable } from './bit-table.tsx';
import { LineSettings, wireSettings } from './line-settings.tsx';
import { usePictureTexts } from './picture/drawing.ts';
import { GUTTER, Picture } from './picture/picture.tsx';
import { ReceivedBytes, ReceiverChoice } from './receiver-panel.tsx';
import { SaveBar } from './save.tsx';
import { Scroller } from './scroller.tsx';

const MILLI = 1000;
/** Pixels that a saved picture is wide. */
const SAVED_WIDTH = 1200;

/** The current frame on a serial line, with the frame it answers or the reply it should have. */
export function LineView({ draft, frame }: WireProps) {
  const words = useWords('wire');
  const texts = usePictureTexts();
  const view = useSignal<StripView>({ width: 0, px: 0, from: 0 });
  const strip = useRef<HTMLElement>(null);
  const [{ gapAt, gapTime }, setGap] = useState<{ readonly gapAt: number | undefined; readonly gapTime: number }>({
    gapAt: undefined,
    gapTime: 2,
  });
  const [kind, setKind] = useState<ReceiverKind>('none');
  const [ownLine, setOwnLine] = useState<SerialLine>();
  const mode = frame.reading.transport === 'ascii' ? 'ascii' : 'rtu';
  const serial = line.setting.value;
  const { level, delay } = wireSettings.value;
  const device = line.isOwn.value ? line.own.value?.name : undefined;
  const last = frame.bytes.length - 1;
  const gap = gapAt !== undefined && gapAt <= last ? { after: gapAt, time: gapTime * MILLI } : undefined;
  const scene = sceneOf(exchangeOf({ draft, frame }), { serial, delay: delay * MILLI, gap });
  const own = ownLine ?? serial;
  const theirs = receiverLine(kind, serial, own);
  const receiver = theirs && receiverFor(kind, serial, theirs);
  const received = receiver && receivedOf(scene, receiver);
  const showByte = (index: number) => {
    view.value = viewOfByte(scene, view.peek(), index);
    strip.current?.scrollIntoView({ block: 'nearest' });
  };
  const picture = (seen: StripView) => (
    <Picture scene={scene} kind={level} view={seen} receiver={receiver} received={received} words={texts} />
  );
  return (
    <>
      <LineSettings
        last={last}
        gapAt={gapAt}
        gapTime={gapTime}
        onGap={(changed) => setGap((before) => ({ ...before, ...changed }))}
      />
      <LineNotes scene={scene} mode={mode} device={device} />
      <Scroller scene={scene} view={view} draw={picture} strip={strip} />
      <p class="said">
        {words.legend} {words.levelNotes[level]}
      </p>
      <SaveBar name={`framewright-${mode}`} picture={() => picture(widened(view.peek()))} />
      <ReceiverChoice kind={kind} own={own} onKind={setKind} onOwn={setOwnLine} />
      {theirs && received && <ReceivedBytes scene={scene} kind={kind} receiver={theirs} received={received} />}
      <Fold summary={words.table}>{() => <BitTable scene={scene} onShow={(index) => showByte(index)} />}</Fold>
    </>
  );
}

interface NotesProps {
  readonly scene: Scene;
  readonly mode: SerialMode;
  readonly device: string | undefined;
}

/** Whether the line as it is set is usual, and what its times are. */
function LineNotes({ scene, mode, device }: NotesProps) {
  const words = useWords('wire');
  const { serial, silences, gap } = scene;
  const standing = formatStanding(mode, serial);
  const effect = gapEffectOf(scene);
  return (
    <p class="said" aria-live="polite">
      {device && `${words.fromDevice(device)} `}
      <span class={standing === 'impossible' ? 'error' : undefined}>{words.standing(standing, mode)}</span>{' '}
      {words.character(bitsPerCharacter(serial), words.time(charactersTime(serial, 1)))}{' '}
      {silences ? words.silences(words.time(silences.t15), words.time(silences.t35)) : words.noSilences}{' '}
      {gap && effect && (
        <span class={effect === 'whole' ? undefined : 'error'}>
          {(silences ? words.gap : words.asciiGap)(words.time(gap.time), effect)}{' '}
        </span>
      )}
      {scene.sent[1]?.current === false && words.expected}
    </p>
  );
}

/** The same stretch of the line at the width of a saved picture. */
function widened(view: StripView): StripView {
  const width = SAVED_WIDTH - GUTTER;
  return { from: view.from, width, px: (view.px * width) / view.width };
}
