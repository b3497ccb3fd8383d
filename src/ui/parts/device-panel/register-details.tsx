import type { WrittenColumn } from '../../../devices/index.ts';
import { type CellEdit, type CellExit, type Drafts, EditedText } from '../../kit/cell-input.tsx';
import { useFocus } from '../../kit/use-focus.ts';
import { useWords } from '../words.ts';

interface DetailsProps {
  readonly name: string;
  readonly fields: readonly { readonly column: WrittenColumn; readonly edit: CellEdit }[];
  readonly drafts: Drafts;
  readonly onRemove: () => void;
}

/** What a register has beside the columns of the grid, each edited where it stands. */
export function RegisterDetails({ name, fields, drafts, onRemove }: DetailsProps) {
  const words = useWords('devices');
  const { root, focus } = useFocus<HTMLDivElement>();
  // The field that is left is drawn anew, and with it the one that gets the focus.
  drafts.ids;
  const exit = (at: number, how: CellExit) => {
    if (how === 'nowhere') return;
    const to = at + { back: 0, down: 1, next: 1, up: -1, previous: -1 }[how];
    const field = fields[Math.max(0, Math.min(fields.length - 1, to))];
    if (field) focus(field.edit.id);
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would frame it.
    <div ref={root} class="device-details" role="group" aria-label={words.editTitle(name)}>
      {fields.map(({ column, edit }, at) => (
        <div key={column} data-field={column}>
          <span class="soft" aria-hidden="true">
            {words.columns[column]}
          </span>
          <EditedText edit={edit} drafts={drafts} onExit={(how) => exit(at, how)}>
            {edit.text}
          </EditedText>
        </div>
      ))}
      <button type="button" class="quiet" aria-label={words.removeOf(name)} onClick={onRemove}>
        {words.remove}
      </button>
    </div>
  );
}
