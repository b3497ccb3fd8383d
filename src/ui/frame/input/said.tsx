import type { ChosenByText, InputAdvice, InputOffer, TextReading } from '../../../workbench/index.ts';
import { Fold } from '../../kit/fold.tsx';
import { useCommand, useKeyOf } from '../../parts/commands.ts';
import { allDevices } from '../../parts/device/chosen.ts';
import { openInLog } from '../../parts/for-log.ts';
import { line } from '../../parts/line.ts';
import { pasted } from '../../parts/pasted.ts';
import { draft, evaluation, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { Answer } from './answer.tsx';
import { TextProblems } from './text-problems.tsx';
import './said.css';
import { otherIdentities, WhatItIs } from './what-it-is.tsx';

interface SaidProps {
  /** Selects a part of the text. */
  readonly onShow: (start: number, end: number) => void;
}

/** What the text of the input was taken for, what else it may be, and what of it could not be read. */
export function Said({ onShow }: SaidProps) {
  const words = useWords('read');
  const state = pasted.state.value;
  if (state.kind !== 'read') return null;
  const { meaning, reading } = state;
  switch (meaning.kind) {
    case 'empty':
      return null;
    case 'frames':
      return (
        <>
          <ReadAs {...state} />
          <TextProblems reading={reading} onShow={onShow} />
        </>
      );
    case 'no-bytes':
      return (
        <>{meaning.advice ? <Advice {...meaning.advice} /> : <TextProblems reading={reading} onShow={onShow} />}</>
      );
    case 'tool':
      return <Answer tool={meaning.tool} />;
    case 'several':
      return (
        <p class="in-row">
          {words.severalMeanings} <Offers offers={meaning.offers} />
        </p>
      );
    default:
      return (
        <>
          <p class="in-row">
            {meaning.kind === 'value-with-unit' ? words.takenForValue(meaning.unknown) : words.taken(meaning.taken)}{' '}
            <Offers offers={meaning.others} />
          </p>
          {meaning.kind === 'address' && meaning.chooses && <Chosen {...meaning.chooses} />}
        </>
      );
  }
}

/** What would do in place of a text that means nothing here. */
function Advice(advice: InputAdvice) {
  const words = useWords('read');
  return (
    <p class="said">
      {words.advice(advice)} {advice.code === 'name-unknown' && <a href="#devices">{words.toDevices}</a>}
    </p>
  );
}

/** Says that a name in the text chose its device, and with it the line; one click chooses the one before again. */
function Chosen({ device, before }: ChosenByText) {
  const words = useWords('read');
  if (allDevices.chosen.value?.id !== device.id) return null;
  return (
    <p class="in-row said">
      {words.chosen(device.name, device.serial && line.isOwn.value ? line.setting.value : undefined)}{' '}
      <button type="button" aria-label={words.undoChosen(device.name)} onClick={() => allDevices.choose(before)}>
        {words.undo}
      </button>
    </p>
  );
}

/** What the text may be, each at one click. */
function Offers({ offers }: { readonly offers: readonly InputOffer[] }) {
  const words = useWords('read');
  return (
    <>
      {offers.map((offer) => (
        <button
          key={words.offer(offer)}
          type="button"
          aria-pressed={draft.value === offer.draft}
          onClick={() => page.choose(offer)}
        >
          {words.offer(offer)}
        </button>
      ))}
    </>
  );
}

/** What the text was read as, and what else it could be, one click each; where another frame is shown, the way back to its own. */
function ReadAs({ reading, chosen }: { readonly reading: TextReading; readonly chosen: number }) {
  const words = useWords('read');
  const { notation, alternatives, bytes, items, text } = reading;
  const frames = items.filter(({ kind }) => kind === 'frame').length;
  const others = otherIdentities();
  const shown = evaluation.value.frame?.bytes;
  const isOther = chosen >= 0 && (shown === undefined || pasted.itemWith(shown) === undefined);
  return (
    <div class="in-row">
      <span>
        {words.readAs(notation)} {words.found(bytes.length, frames)}
      </span>
      {items.length > 1 && <LogOffer text={text} />}
      {isOther && (
        <button type="button" onClick={() => pasted.choose(chosen, 'step')}>
          {words.showAgain}
        </button>
      )}
      {alternatives.length + others.length > 0 && <span class="soft">{words.instead}</span>}
      {alternatives.map((other) => (
        <button
          key={other.reading}
          type="button"
          aria-label={words.choose(other.reading)}
          title={words.otherwise(other.reading, other.bytes)}
          onClick={() => pasted.read(text, 'step', other.reading)}
        >
          {words.readings[other.reading]}
        </button>
      ))}
      {others.map((identity) => {
        const name = words.kindOf(identity);
        return (
          <button
            key={name}
            type="button"
            aria-label={words.readSo(name)}
            onClick={() => page.showReading(identity.reading, pasted.identity.peek()?.request, 'step')}
          >
            {name}
          </button>
        );
      })}
      <Fold summary={words.whatElse}>{() => <WhatItIs />}</Fold>
    </div>
  );
}

/** The way to the list of all frames of the text; the keys for faults lead there too. */
function LogOffer({ text }: { readonly text: string }) {
  const words = useWords('read');
  const open = () => openInLog(text);
  useCommand('next-fault', open);
  return (
    <button type="button" {...useKeyOf('next-fault')} onClick={open}>
      {words.openInLog}
    </button>
  );
}
