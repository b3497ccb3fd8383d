import { useMemo } from 'preact/hooks';
import type { WireWords } from '../../../../../words/index.ts';
import type { FieldNames, Scene, StripView, Track } from '../../../../../workbench/index.ts';
import { useWords } from '../../../words.ts';

/** What stands in a picture. It comes as a property: a picture that is saved stands outside of the page and its language. */
export type PictureTexts = WireWords & FieldNames;

export function usePictureTexts(): PictureTexts {
  const wire = useWords('wire');
  const { labels, short } = useWords('page');
  return useMemo(() => ({ ...wire, labels, short }), [wire, labels, short]);
}

/** What every part of a waveform is drawn by. */
export interface Drawing {
  readonly scene: Scene;
  /** What is in sight, right of the names. */
  readonly view: StripView;
  readonly tracks: readonly Track[];
  readonly words: PictureTexts;
}
