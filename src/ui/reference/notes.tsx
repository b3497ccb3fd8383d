import { type Misprint, misprints, type OpenPoint, openPoints } from '../../workbench/index.ts';
import { type Entry, frameLink, type Say, type Section, sectionCell } from './entry.tsx';

/** What the specification leaves open. */
export function openSection(say: Say): Section {
  const { columns: c, openPoints: texts } = say.text;
  return {
    subject: 'open',
    columns: [c.point, c.known, c.section],
    entries: (Object.keys(openPoints) as OpenPoint[]).map((key) => {
      const { sections, frame } = openPoints[key];
      const { title, text: known } = texts[key];
      return {
        key,
        codes: [],
        also: 'ambiguous open',
        cells: [frame ? frameLink(frame, title) : title, known, sectionCell(say, ...sections)],
      };
    }),
  };
}

/** Errors in the print of the specifications. */
export function misprintSection(say: Say): Section {
  const { columns: c } = say.text;
  return {
    subject: 'misprints',
    columns: [c.source, c.printed, c.right, c.why, c.gravity],
    entries: (Object.keys(misprints) as Misprint[]).map((key) => misprintEntry(key, say)),
  };
}

const TONES = { wrong: 'error', ambiguous: 'warning', note: 'note' } as const;

function misprintEntry(key: Misprint, say: Say): Entry {
  const { text } = say;
  const { sections, gravity } = misprints[key];
  const { printed, kind, why, right } = text.misprints[key];
  return {
    key,
    codes: [],
    also: 'misprint',
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
