import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import {
  accesses,
  byteOrders,
  type Cells,
  cellsOf,
  registerColumns as columns,
  entityTables,
  type Profile,
  placeOfRegister,
  type Register,
  readCells,
  type TableFault,
  valueTypes,
} from '../../../devices/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Field } from '../../kit/field.tsx';
import { TextInput } from '../../kit/text-input.tsx';
import { useWords } from '../words.ts';

type Column = (typeof columns)[number];

const CHOICES: Readonly<Partial<Record<Column, readonly string[]>>> = {
  table: entityTables,
  type: valueTypes,
  order: byteOrders,
  access: accesses,
};

/** The field beside which a fault stands that names no column. */
const PLACES: Readonly<Partial<Record<TableFault['code'], Column>>> = {
  'factor-zero': 'factor',
  'over-the-end': 'count',
  'names-unreadable': 'names',
  'type-not-for-table': 'type',
  'table-read-only': 'access',
  'name-twice': 'name',
};

interface EditorProps {
  readonly profile: Profile;
  /** The register to be changed, or nothing for a new one. */
  readonly register: Register | undefined;
  readonly onKeep: (register: Register) => void;
  readonly onCancel: () => void;
}

/** A register as texts, read by the rules of an imported row. */
export function RegisterEditor({ profile, register, onKeep, onCancel }: EditorProps) {
  const words = useWords('devices');
  const root = useRef<HTMLFormElement>(null);
  const [cells, setCells] = useState<Cells>(register ? cellsOf(register) : { table: 'holding-register', type: 'u16' });
  // Missing cells are faults only after the first attempt to keep the register.
  const [tried, setTried] = useState(0);
  useLayoutEffect(() => root.current?.querySelector('input')?.focus(), []);
  useLayoutEffect(() => {
    if (tried > 0) root.current?.querySelector<HTMLElement>('[aria-invalid="true"]')?.focus();
  }, [tried]);
  const reading = readCells(cells, profile);
  const faults = [...(reading.kind === 'faults' ? reading.faults : []), ...namedTwice(cells, profile, register)];
  const keep = (event: Event) => {
    event.preventDefault();
    if (faults.length === 0 && reading.kind === 'register') onKeep(reading.register);
    else setTried(tried + 1);
  };
  return (
    <form
      class="device-editor"
      ref={root}
      aria-label={register ? words.editTitle(register.name) : words.addTitle}
      onSubmit={keep}
      onKeyDown={({ key }) => {
        if (key === 'Escape') onCancel();
      }}
    >
      <div class="field-grid">
        {columns.map((column) => (
          <Cell
            key={column}
            column={column}
            text={cells[column] ?? ''}
            faults={faults.filter((fault) => placeOf(fault) === column && (tried > 0 || fault.code !== 'cell-missing'))}
            onText={(text) => setCells({ ...cells, [column]: text })}
          />
        ))}
      </div>
      <p class="in-row">
        <button type="submit" class="first">
          {words.keep}
        </button>
        <button type="button" onClick={onCancel}>
          {words.cancel}
        </button>
      </p>
    </form>
  );
}

function namedTwice(cells: Cells, profile: Profile, register: Register | undefined): readonly TableFault[] {
  const name = cells.name?.trim() ?? '';
  const reading = readCells(cells, profile);
  const place = reading.kind === 'register' ? placeOfRegister(reading.register) : undefined;
  const first = profile.registers.findIndex((each) => each !== register && placeOfRegister(each) === place);
  return first < 0 ? [] : [{ code: 'name-twice', name, first: first + 1 }];
}

const placeOf = (fault: TableFault) => ('column' in fault ? fault.column : PLACES[fault.code]);

interface CellProps {
  readonly column: Column;
  readonly text: string;
  readonly faults: readonly TableFault[];
  readonly onText: (text: string) => void;
}

function Cell({ column, text, faults, onText }: CellProps) {
  const words = useWords('devices');
  const id = `device-${column}`;
  const choices = CHOICES[column];
  return (
    <Field
      id={id}
      name={column}
      label={words.columns[column]}
      hint={words.cellHints[column]}
      error={faults.map(words.fault).join(' ')}
    >
      {choices ? (
        <Select
          id={id}
          value={text}
          options={[
            ...(choices.includes(text) ? [] : [{ value: text, name: text || words.usual }]),
            ...choices.map((choice) => ({ value: choice, name: choice })),
          ]}
          wrong={faults.length > 0}
          onChoose={onText}
        />
      ) : (
        <TextInput id={id} text={text} wrong={faults.length > 0} onText={onText} />
      )}
    </Field>
  );
}
