import {
  canRead,
  canWrite,
  type FoundRegister,
  lineName,
  type Profile,
  printedNumber,
  type Register,
  type RegisterRequest,
  readRequest,
  readRequests,
  stepOf,
  valueName,
  writeRequest,
} from '../../../devices/index.ts';
import { deviceRequest } from '../../../workbench/index.ts';
import { draft } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { stepTo } from '../current-frame.ts';

/** Most lines drawn at once; a search finds the others. */
const SHOWN = 100;

interface TableProps {
  readonly profile: Profile;
  readonly found: readonly FoundRegister[];
  readonly onTaken: (message: string) => void;
  readonly onEdit: (register: Register) => void;
  readonly onRemove: (register: Register) => void;
}

/** The registers of a device, each with buttons that make its requests. */
export function RegisterTable({ profile, found, ...acts }: TableProps) {
  const words = useWords('devices');
  if (found.length === 0) return null;
  const { columns } = words;
  return (
    <>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls sideways must be reached by the keyboard. */}
      <section class="device-table" aria-label={words.table} tabIndex={0}>
        <table>
          <thead>
            <tr>
              {[columns.name, columns.number, columns.type, columns.unit, columns.access, columns.description].map(
                (name) => (
                  <th key={name} scope="col">
                    {name}
                  </th>
                ),
              )}
              <th scope="col">{words.actions}</th>
            </tr>
          </thead>
          <tbody>
            {found.slice(0, SHOWN).map((each) => (
              <RegisterRow key={each.register.name} profile={profile} found={each} {...acts} />
            ))}
          </tbody>
        </table>
      </section>
      {found.length > SHOWN && <p class="said">{words.more(found.length - SHOWN)}</p>}
    </>
  );
}

interface RowProps extends Omit<TableProps, 'found'> {
  readonly found: FoundRegister;
}

function RegisterRow({ profile, found: { register, index }, onTaken, onEdit, onRemove }: RowProps) {
  const words = useWords('devices');
  const { table, unit, count, access, description, names } = register;
  const name = index === undefined ? lineName(register) : valueName(register, index);
  const address = register.address + (index ?? 0) * stepOf(register, profile);
  const parts = index === undefined && canRead(register) ? readRequests(profile, register).length : 1;
  const take = (make: (...line: Parameters<typeof readRequest>) => RegisterRequest) => {
    stepTo(deviceRequest(draft.value, make(profile, register, index), profile.serial));
    onTaken(words.taken(name, make === readRequest ? parts : 1));
  };
  const details = [
    description,
    names.map(({ number, name: called }) => `${number} ${called}`).join(', '),
    words.scaleText(register),
    index === undefined && count > 1 ? words.countText(count) : '',
    parts > 1 ? words.readBy(parts) : '',
  ].filter((part) => part !== '');
  return (
    <tr>
      <th scope="row">{name}</th>
      <td class="mono">{words.number(printedNumber(profile.convention, table, address), address)}</td>
      <td>{words.typeText(register)}</td>
      <td>{unit}</td>
      <td>{words.accesses[access]}</td>
      <td>
        {details.map((part) => (
          <span key={part} class="part">
            {part}
          </span>
        ))}
      </td>
      <td>
        <span class="device-actions">
          {canRead(register) && (
            <button type="button" aria-label={words.readOf(name)} onClick={() => take(readRequest)}>
              {words.read}
            </button>
          )}
          {canWrite(register) && (
            <button type="button" aria-label={words.writeOf(name)} onClick={() => take(writeRequest)}>
              {words.write}
            </button>
          )}
          <button
            type="button"
            aria-label={words.editOf(register.name)}
            data-focus={`edit ${register.name}`}
            onClick={() => onEdit(register)}
          >
            {words.edit}
          </button>
          <button type="button" aria-label={words.removeOf(register.name)} onClick={() => onRemove(register)}>
            {words.remove}
          </button>
        </span>
      </td>
    </tr>
  );
}
