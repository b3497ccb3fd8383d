import type { Profile, Register, TableFault, WrittenColumn } from '../../../devices/index.ts';
import { cellChoices, cellText, withCell } from '../../../workbench/index.ts';
import type { CellEdit } from '../../kit/cell-input.tsx';

interface EditWords {
  readonly columns: Readonly<Record<WrittenColumn, string>>;
  readonly cellHints: Readonly<Partial<Record<string, string>>>;
  readonly cellOf: (column: string, name: string) => string;
  readonly fault: (fault: TableFault) => string;
}

interface EditedRegister {
  readonly profile: Profile;
  readonly register: Register;
  /** Its place in the list of registers, which an edit leaves as it is. */
  readonly at: number;
  readonly onKeep: (at: number, register: Register) => void;
}

/** How a cell of a register is edited: by the rules of an imported row. */
export function cellEdit(words: EditWords, of: EditedRegister, column: WrittenColumn): CellEdit {
  const { profile, register, at, onKeep } = of;
  const hint = words.cellHints[column];
  const read = (text: string) => withCell(profile, register, column, text);
  return {
    id: `${at}-${column}`,
    label: words.cellOf(words.columns[column], register.name),
    text: cellText(register, column),
    choices: cellChoices(column)?.map((value) => ({ value, name: value })),
    hint,
    fault(text) {
      const edited = read(text);
      if (edited.kind === 'register') return '';
      return [...edited.faults.map(words.fault), ...(hint ? [hint] : [])].join(' ');
    },
    take(text) {
      const edited = read(text);
      if (edited.kind === 'register') onKeep(at, edited.register);
    },
  };
}
