import { addressOf } from '../../store/index.ts';
import {
  evaluate,
  firstContext,
  firstDraft,
  type Misprint,
  misprints,
  type OpenPoint,
  openPoints,
  type Trouble,
  type TroublePlace,
  troubles,
  writeLink,
} from '../../workbench/index.ts';
import { type Entry, frameLink, type Say, sectionCell } from './entry.tsx';

/** What the specification leaves open. */
export function openEntries(say: Say): readonly Entry[] {
  const { openPoints: texts } = say.text;
  return (Object.keys(openPoints) as OpenPoint[]).map((key) => {
    const { sections, frame } = openPoints[key];
    const { title, text: known } = texts[key];
    return {
      key,
      cells: [frame ? frameLink(frame, title) : title, known, sectionCell(say, ...sections)],
    };
  });
}

const frameOnWire = () => `#${writeLink(firstDraft, evaluate(firstDraft).controls, { ...firstContext, tab: 'wire' })}`;

const PLACES: Readonly<Record<TroublePlace, () => string>> = {
  checklist: () => addressOf('bus', { tab: 'no-answer' }),
  scan: () => addressOf('bus', { tab: 'scan' }),
  bus: () => '#bus',
  timing: () => '#timing',
  wire: frameOnWire,
};

/** Signs that something is wrong on the line, with the way to the place that helps. */
export const troubleEntries = (say: Say): readonly Entry[] =>
  (Object.keys(troubles) as Trouble[]).map((key) => {
    const { sections, place } = troubles[key];
    const { title, text } = say.text.troubles[key];
    return {
      key,
      cells: [
        title,
        text,
        <a key="place" href={PLACES[place]()}>
          {say.text.troublePlaces[place]}
        </a>,
        sectionCell(say, ...sections),
      ],
    };
  });

/** Errors in the print of the specifications. */
export const misprintEntries = (say: Say): readonly Entry[] =>
  (Object.keys(misprints) as Misprint[]).map((key) => misprintEntry(key, say));

const TONES = { wrong: 'error', ambiguous: 'warning', note: 'note' } as const;

function misprintEntry(key: Misprint, say: Say): Entry {
  const { text } = say;
  const { sections, gravity } = misprints[key];
  const { printed, kind, why, right } = text.misprints[key];
  return {
    key,
    cells: [
      sectionCell(say, ...sections),
      printed,
      right,
      <>
        <b>{`${kind.charAt(0).toUpperCase()}${kind.slice(1)}.`}</b> {why}
      </>,
      <span key="gravity" class="gravity" data-severity={TONES[gravity]}>
        {text.gravities[gravity]}
      </span>,
    ],
  };
}
