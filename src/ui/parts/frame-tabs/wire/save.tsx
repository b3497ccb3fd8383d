import { type ComponentChildren, render } from 'preact';
import { useState } from 'preact/hooks';
import { dictionary } from '../../../../modbus/index.ts';
import { putOnClipboard } from '../../../kit/clipboard.ts';
import { download } from '../../../kit/download.ts';
import { png } from '../../../kit/picture-file.ts';
import { useWords } from '../../words.ts';

interface SaveProps {
  /** Draws the picture for saving. */
  readonly picture: () => ComponentChildren;
  /** The name of the file, without its ending. */
  readonly name: string;
}

/** Saves or copies the picture that is shown, with light colours and everything it needs in itself. */
export function SaveBar({ picture, name }: SaveProps) {
  const words = useWords('wire');
  const [outcome, setOutcome] = useState<string>();
  const svg = () => standalone(picture());
  const save = async (make: () => Blob | Promise<Blob>, ending: string, refused: string) => {
    const file = `${name}.${ending}`;
    try {
      download(await make(), file);
    } catch {
      return refused;
    }
    return words.saved(file);
  };
  const copy = async (make: () => string | Promise<Blob>) =>
    (await putOnClipboard(make())) ? words.copied : words.refused;
  const acts = {
    [words.saveSvg]: () => save(() => new Blob([svg()], { type: 'image/svg+xml' }), 'svg', words.refused),
    [words.savePng]: () => save(() => png(svg()), 'png', words.noPng),
    [words.copySvg]: () => copy(svg),
    [words.copyPng]: () => copy(() => png(svg())),
  };
  return (
    <div class="actions">
      {Object.entries(acts).map(([label, act]) => (
        <button key={label} type="button" onClick={() => void act().then(setOutcome)}>
          {label}
        </button>
      ))}
      <output>{outcome}</output>
    </div>
  );
}

/** Properties that a picture takes from the page's styles; other programs read them as attributes. */
const STYLES = [
  'fill',
  'fill-opacity',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-linejoin',
  'font-family',
  'font-size',
  'font-weight',
  'text-anchor',
] as const;

/** A picture as a file of its own: in light colours whatever the page has, each element with its own style. */
function standalone(picture: ComponentChildren): string {
  const stage = document.createElement('div');
  stage.className = 'for-paper';
  document.body.append(stage);
  try {
    render(picture, stage);
    const svg = stage.querySelector('svg');
    if (svg === null) throw new Error('There is no picture.');
    for (const element of svg.querySelectorAll('rect, path, text')) {
      const style = getComputedStyle(element);
      for (const name of STYLES) {
        const value = style.getPropertyValue(name);
        if (value !== INITIAL[name]) element.setAttribute(name, value);
      }
    }
    const paper = document.createElementNS(svg.namespaceURI, 'rect');
    paper.setAttribute('width', '100%');
    paper.setAttribute('height', '100%');
    paper.setAttribute('fill', '#ffffff');
    svg.prepend(paper);
    return new XMLSerializer().serializeToString(svg);
  } finally {
    render(null, stage);
    stage.remove();
  }
}

/** What an attribute need not say. */
const INITIAL: Readonly<Record<string, string>> = dictionary({
  'fill-opacity': '1',
  stroke: 'none',
  'stroke-dasharray': 'none',
  'stroke-linejoin': 'miter',
  'text-anchor': 'start',
});
