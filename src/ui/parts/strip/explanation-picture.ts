import { toHex } from '../../../modbus/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { character, type Explained, explain, framePicture, verdictOf } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { png } from '../../kit/picture-file.ts';
import type { Found } from './found.ts';

/** Bytes of a field that the picture shows; a longer field is shown by its ends. */
const SHOWN = 12;
/** Lines of the picture: more would be a file that nobody reads. */
const LINES = 60;

type PictureWords = Pick<WordsOf<'page'>, 'strip' | 'short'>;

/** A picture of an explained frame, to be pasted or saved. */
export function pictureOf(of: Explained, { strip, short }: PictureWords, found: Found | undefined) {
  const { reading, bytes, words, names, sixDigits } = of;
  const verdict = verdictOf(reading);
  const wrong = verdict !== 'valid' && verdict !== 'doubtful';
  const fields = reading.spans.map((span) => {
    const cells = Array.from(bytes.subarray(span.from, span.to), (byte) =>
      reading.transport === 'ascii' ? character(byte) : toHex(Uint8Array.of(byte)),
    );
    return {
      label: short[span.name] ?? (words.labels[span.name] ?? span.name).toLowerCase(),
      kind: span.kind,
      cells: cells.length > SHOWN ? [...cells.slice(0, SHOWN / 2), '…', ...cells.slice(-2)] : cells,
      note: strip.note({ reading, span, named: names?.short(span.name) ?? '', sixDigits }),
      wrong: reading.problems.some(
        ({ severity, span: at }) => severity === 'error' && at.from < span.to && at.to > span.from,
      ),
    };
  });
  const svg = framePicture({
    verdict: `${strip.verdict(verdict, reading)}: ${strip.kindAndSize(reading, bytes.length)}`,
    wrong,
    cause: found?.of === bytes && wrong ? found.cause : '',
    fields,
    lines: explain(of)
      .filter(({ depth }) => depth === 0)
      .slice(0, LINES),
  });
  return {
    png: () => png(svg),
    save: (name: string) => download(new Blob([svg], { type: 'image/svg+xml' }), `${name}.svg`),
  };
}
