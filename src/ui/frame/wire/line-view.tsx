import { Component } from 'preact';
import {
  bitsPerCharacter,
  charactersTime,
  formatStanding,
  type SerialLine,
  type SerialMode,
} from '../../../modbus/index.ts';
import type { StripView } from '../../../workbench/index.ts';
import {
  exchangeOf,
  gapEffectOf,
  type ReceiverKind,
  receivedOf,
  receiverFor,
  receiverLine,
  type Scene,
  sceneOf,
  type WireProps,
} from '../../../workbench/index.ts';
import { Fold } from '../../kit/fold.tsx';
import { BitTable } from './bit-table.tsx';
import { currentLine } from './line-memory.ts';
import { LineSettings } from './line-settings.tsx';
import { GUTTER, Picture } from './picture/picture.tsx';
import { ReceivedBytes, ReceiverChoice } from './receiver-panel.tsx';
import { SaveBar } from './save.tsx';
import { Scroller } from './scroller.tsx';
import { wireWords as words } from './wire-words.ts';

interface LineState {
  readonly gapAt: number | undefined;
  /** Milliseconds. */
  readonly gapTime: number;
  readonly receiver: ReceiverKind;
  readonly own: SerialLine | undefined;
}

const MILLI = 1000;
/** Pixels that a saved picture is wide. */
const SAVED_WIDTH = 1200;

/** The current frame on a serial line, with the frame it answers or the reply it should have. */
export class LineView extends Component<WireProps, LineState> {
  override state: LineState = { gapAt: undefined, gapTime: 2, receiver: 'none', own: undefined };
  private scroller: Scroller | undefined;

  render() {
    const { frame } = this.props;
    const mode = frame.reading.transport === 'ascii' ? 'ascii' : 'rtu';
    const choice = currentLine(mode);
    const { serial, level } = choice;
    const last = frame.bytes.length - 1;
    const { gapAt, gapTime } = this.state;
    const gap = gapAt !== undefined && gapAt <= last ? { after: gapAt, time: gapTime * MILLI } : undefined;
    const scene = sceneOf(exchangeOf(this.props), { serial, delay: choice.delay * MILLI, gap });
    const own = this.state.own ?? serial;
    const line = receiverLine(this.state.receiver, serial, own);
    const receiver = line && receiverFor(this.state.receiver, serial, line);
    const received = receiver && receivedOf(scene, receiver);
    const picture = (view: StripView) => (
      <Picture scene={scene} kind={level} view={view} receiver={receiver} received={received} />
    );
    return (
      <>
        <LineSettings
          mode={mode}
          last={last}
          gapAt={gapAt}
          gapTime={gapTime}
          onGap={(changed) => this.setState(changed)}
        />
        <Said scene={scene} mode={mode} device={choice.device} />
        <Scroller
          scene={scene}
          onReady={(scroller) => {
            this.scroller = scroller;
          }}
          draw={picture}
        />
        <p class="said">
          {words.legend} {words.levelNotes[level]}
        </p>
        <SaveBar name={`framewright-${mode}`} picture={() => this.scroller && picture(widened(this.scroller.view))} />
        <ReceiverChoice
          kind={this.state.receiver}
          own={own}
          onKind={(kind) => this.setState({ receiver: kind })}
          onOwn={(changed) => this.setState({ own: changed })}
        />
        {line && received && (
          <ReceivedBytes scene={scene} kind={this.state.receiver} receiver={line} received={received} />
        )}
        <Fold summary={words.table}>
          {() => <BitTable scene={scene} onShow={(index) => this.scroller?.showByte(index)} />}
        </Fold>
      </>
    );
  }
}

interface SaidProps {
  readonly scene: Scene;
  readonly mode: SerialMode;
  readonly device: string | undefined;
}

/** What the page says of the line as it is set. */
function Said({ scene, mode, device }: SaidProps) {
  const { serial, silences } = scene;
  const standing = formatStanding(mode, serial);
  const gap = gapSaid(scene);
  return (
    <p class="said" aria-live="polite">
      {device && `${words.fromDevice(device)} `}
      <span class={standing === 'impossible' ? 'error' : undefined}>{words.standing(standing, mode)}</span>{' '}
      {words.character(bitsPerCharacter(serial), words.time(charactersTime(serial, 1)))}{' '}
      {silences ? words.silences(words.time(silences.t15), words.time(silences.t35)) : words.noSilences}{' '}
      {gap && <span class={gap.effect === 'whole' ? undefined : 'error'}>{gap.text} </span>}
      {scene.sent[1]?.current === false && words.expected}
    </p>
  );
}

/** What the gap in the frame does; `undefined` if it has no gap. */
function gapSaid(scene: Scene) {
  const { gap, silences } = scene;
  const effect = gapEffectOf(scene);
  if (gap === undefined || effect === undefined) return undefined;
  const length = words.time(gap.time);
  return { effect, text: silences ? words.gap(length, effect) : words.asciiGap(length, effect) };
}

/** The same stretch of the line at the width of a saved picture. */
function widened(view: StripView): StripView {
  const width = SAVED_WIDTH - GUTTER;
  return { from: view.from, width, px: (view.px * width) / view.width };
}
