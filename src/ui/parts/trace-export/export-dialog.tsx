import { useEffect, useState } from 'preact/hooks';
import type { ExportedFile, NotExported, TraceView } from '../../../store/index.ts';
import { type ExportWanted, exportFiles, exportFormats, exportName } from '../../../workbench/index.ts';
import { putOnClipboard } from '../../kit/clipboard.ts';
import { Dialog } from '../../kit/dialog.tsx';
import { download } from '../../kit/download.ts';
import { Segments } from '../../kit/segments.tsx';
import { useWords } from '../words.ts';
import './export-dialog.css';

interface ExportDialogProps {
  readonly of: TraceView<File>;
  readonly wanted: ExportWanted;
  readonly onWant: (wanted: ExportWanted) => void;
  readonly onClose: () => void;
}

const REPLACED = ['units', 'addresses', 'times'] as const;

/** Saves a trace as a file, or copies a report of it. */
export function ExportDialog({ of, wanted, onWant, onClose }: ExportDialogProps) {
  const words = useWords('trace');
  const { export: own } = words;
  const { format, replaced } = wanted;
  const filter = of.applied.value;
  const [ofFiltered, setOfFiltered] = useState(filter !== '');
  const [said, setSaid] = useState('');
  useEffect(() => of.exports.cancel, []);
  const state = of.state.value;
  const source = state.kind === 'open' ? words.source(state.name, state.format, of.own.value) : '';
  const name = exportName(wanted, state.kind === 'open' ? state.name : undefined);
  const { type } = exportFiles[format];
  const make = () => {
    setSaid('');
    return of.exports.make({ wanted, ofFiltered, source });
  };
  const blobOf = ({ parts }: ExportedFile<File>) => new Blob([...parts], { type });
  const fail = (why: NotExported) => setSaid(own.notMade[why]);
  const save = async () => {
    const made = await make();
    if (typeof made === 'string') return fail(made);
    const file = blobOf(made);
    download(file, name);
    setSaid(own.saved(name, made.frames, file.size));
  };
  const copy = async () => {
    const making = make();
    // The browser wants the text promised at once.
    const text = making.then((made) => {
      if (typeof made === 'string') throw new DOMException(made, 'AbortError');
      return new Blob([...made.parts], { type: 'text/plain' });
    });
    const isCopied = await putOnClipboard(text, 'text/plain');
    const made = await making;
    if (typeof made === 'string') fail(made);
    else setSaid(isCopied ? own.copied(made.frames) : own.refused);
  };
  const { value: percent } = of.exports.percent;
  const isMaking = percent !== undefined;
  const anyReplaced = REPLACED.some((kind) => replaced[kind]);
  const actions = (
    <>
      <button type="button" onClick={onClose}>
        {own.close}
      </button>
      {format === 'report' && (
        <button type="button" disabled={isMaking} onClick={() => void copy()}>
          {own.copy}
        </button>
      )}
      <button type="button" class="first" disabled={isMaking} onClick={() => void save()}>
        {own.save}
      </button>
    </>
  );
  return (
    <Dialog title={own.title} onClose={onClose} actions={actions}>
      <div class="trace-export">
        <Segments
          label={own.format}
          options={exportFormats.map((value) => ({ value, name: own.formats[value] }))}
          value={format}
          onChoose={(chosen) => onWant({ ...wanted, format: chosen })}
        />
        <p class="said">{own.formatHints[format]}</p>
        {filter !== '' && (
          <Segments
            label={own.which}
            options={[
              { value: 'all', name: own.all(of.summary.value?.frames ?? 0) },
              { value: 'filtered', name: own.filtered(of.rowsKept.value - of.piecesKept.value, of.by.value) },
            ]}
            value={ofFiltered ? 'filtered' : 'all'}
            onChoose={(which) => setOfFiltered(which === 'filtered')}
          />
        )}
        <fieldset>
          <legend>{own.replace}</legend>
          {REPLACED.map((kind) => (
            <label key={kind}>
              <input
                type="checkbox"
                checked={replaced[kind] ?? false}
                onChange={({ currentTarget }) =>
                  onWant({ ...wanted, replaced: { ...replaced, [kind]: currentTarget.checked } })
                }
              />
              <span>{own.replaced[kind]}</span>
            </label>
          ))}
          {anyReplaced && <p class="said">{own.kept}</p>}
        </fieldset>
        {isMaking && (
          <p class="in-row">
            <progress aria-label={own.making} max={100} value={percent} />
            <span aria-hidden="true">{own.made(percent)}</span>
            <button type="button" onClick={of.exports.cancel}>
              {own.cancel}
            </button>
          </p>
        )}
        <p class="said" role="status">
          {said}
        </p>
      </div>
    </Dialog>
  );
}
