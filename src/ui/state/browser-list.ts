import { type Kept, KeptList, type ListCodec } from '../../workbench/index.ts';
import { Cell } from './cell.ts';

/** Follows what other tabs store of a list. Answers how to stop. */
export function followStorage(
  list: Pick<KeptList<unknown, unknown>, 'key' | 'reload'>,
  onChange: () => void,
): () => void {
  const follow = ({ key }: StorageEvent) => {
    if (key !== list.key && key !== null) return;
    list.reload();
    onChange();
  };
  addEventListener('storage', follow);
  return () => removeEventListener('storage', follow);
}

/** A list kept in this browser, which other tabs may change too; the page is drawn again when it changes. */
export class BrowserList<T, Fault, Bad = never> extends KeptList<T, Fault, Bad> {
  /** The list as this tab knows it. */
  readonly stored: Cell<Kept<T, Fault, Bad>>;

  constructor(name: string, codec: ListCodec<T, Fault, Bad>) {
    super(name, codec, () => localStorage);
    this.stored = new Cell(this.kept);
  }

  protected override changed(kept: Kept<T, Fault, Bad>): void {
    this.stored.value = kept;
  }

  /** Follows what other tabs store. Answers how to stop. */
  followOtherTabs(onChange: () => void): () => void {
    return followStorage(this, onChange);
  }
}
