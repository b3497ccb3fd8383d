import { Component } from 'preact';
import {
  accesses,
  byteOrders,
  type Cells,
  cellsOf,
  registerColumns as columns,
  entityTables,
  type Profile,
  type Register,
  readCells,
  type TableFault,
  valueTypes,
} from '../../../devices/index.ts';
import { Field, saidId } from '../../kit/field.tsx';
import { deviceWords as words } from '../../parts/device/device-words.ts';

type OwnColumn = (typeof columns)[number];

const CHOICES: Readonly<Partial<Record<OwnColumn, readonly string[]>>> = {
  table: entityTables,
  type: valueTypes,
  order: byteOrders,
  access: accesses,
};

/** The field beside which a fault that names no column is said. */
const PLACES: Readonly<Partial<Record<TableFault['code'], OwnColumn>>> = {
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

interface EditorState {
  readonly cells: Cells;
  /** What is missing is said only once it was to be kept. */
  readonly tried: boolean;
}

/** A register as texts, read by the rules of an imported row. */
export class RegisterEditor extends Component<EditorProps, EditorState> {
  override state: EditorState = {
    cells: this.props.register ? cellsOf(this.props.register) : { table: 'holding-register', type: 'u16' },
    tried: false,
  };
  private root: HTMLFormElement | null = null;

  override componentDidMount() {
    this.root?.querySelector('input')?.focus();
  }

  private faults(): readonly TableFault[] {
    const { profile, register } = this.props;
    const { cells } = this.state;
    const reading = readCells(cells, profile);
    const name = cells.name?.trim() ?? '';
    const first = profile.registers.findIndex((each) => each.name === name && each !== register);
    const twice: TableFault[] = first < 0 ? [] : [{ code: 'name-twice', name, first: first + 1 }];
    return [...(reading.kind === 'faults' ? reading.faults : []), ...twice];
  }

  private readonly keep = (event: Event): void => {
    event.preventDefault();
    const reading = readCells(this.state.cells, this.props.profile);
    if (this.faults().length === 0 && reading.kind === 'register') this.props.onKeep(reading.register);
    else this.setState({ tried: true }, () => this.root?.querySelector<HTMLElement>('[aria-invalid="true"]')?.focus());
  };

  render() {
    const { register, onCancel } = this.props;
    const faults = this.faults();
    return (
      <form
        class="device-editor"
        ref={(root) => {
          this.root = root;
        }}
        aria-label={register ? words.editTitle(register.name) : words.addTitle}
        onSubmit={this.keep}
        onKeyDown={(event) => {
          if (event.key !== 'Escape') return;
          event.preventDefault();
          onCancel();
        }}
      >
        <div class="fields">{columns.map((column) => this.field(column, faults))}</div>
        <p class="device-actions">
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

  private field(column: OwnColumn, faults: readonly TableFault[]) {
    const { cells, tried } = this.state;
    const here = faults.filter(
      (fault) =>
        ('column' in fault ? fault.column : PLACES[fault.code]) === column && (tried || fault.code !== 'cell-missing'),
    );
    const id = `device-${column}`;
    const input = {
      id,
      value: cells[column] ?? '',
      'aria-invalid': here.length > 0,
      'aria-describedby': saidId(id),
      onInput: ({ currentTarget }: { currentTarget: HTMLInputElement | HTMLSelectElement }) =>
        this.setState({ cells: { ...this.state.cells, [column]: currentTarget.value } }),
    };
    const choices = CHOICES[column];
    return (
      <Field
        key={column}
        id={id}
        name={column}
        label={words.columns[column]}
        hint={words.cellHints[column]}
        error={here.map(words.fault).join(' ')}
      >
        {choices ? (
          <select {...input}>
            {!choices.includes(input.value) && <option value={input.value}>{input.value || words.usual}</option>}
            {choices.map((choice) => (
              <option key={choice} value={choice}>
                {choice}
              </option>
            ))}
          </select>
        ) : (
          <input {...input} autocomplete="off" spellcheck={false} />
        )}
      </Field>
    );
  }
}
