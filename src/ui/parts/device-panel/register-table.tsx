import {
  canRead,
  canWrite,
  type FoundRegister,
  type Profile,
  placeOfRegister,
  type Register,
  type RegisterRequest,
  readRequests,
  readWithScale,
  writeRequest,
} from '../../../devices/index.ts';
import {
  deviceRequest,
  foundName,
  foundNumber,
  type RegisterSort,
  type RegisterSortKey,
} from '../../../workbench/index.ts';
import { sortHead, Table } from '../../kit/table.tsx';
import { draft, step } from '../store.ts';
import { useWords } from '../words.ts';

/** Most lines drawn at once; a search finds the others. */
const SHOWN = 100;

/** What is done with a register. */
export interface RegisterActs {
  readonly onTaken: (message: string) => void;
  readonly onEdit: (register: Register) => void;
  readonly onRemove: (register: Register) => void;
}

interface TableProps extends RegisterActs {
  readonly profile: Profile;
  readonly found: readonly FoundRegister[];
  readonly sort: RegisterSort | undefined;
  readonly onSort: (sort: RegisterSort | undefined) => void;
}

/** The registers of a device, each with buttons that make its requests. */
export function RegisterTable({ profile, found, sort, onSort, onTaken, onEdit, onRemove }: TableProps) {
  const words = useWords('devices');
  if (found.length === 0) return null;
  const { columns } = words;
  const head = (column: RegisterSortKey) => sortHead(column, columns[column], sort, onSort);
  return (
    <>
      <Table
        class="device-table"
        label={words.table}
        narrow="cards many"
        rows={found.slice(0, SHOWN)}
        keyOf={({ register, index }) => `${placeOfRegister(register)} ${index}`}
        columns={[
          { ...head('name'), cell: foundName },
          { name: words.actions, cell: (each) => <Requests profile={profile} found={each} onTaken={onTaken} /> },
          { ...head('number'), class: 'mono', cell: (each) => words.number(...foundNumber(profile, each)) },
          { ...head('type'), class: 'register-type', cell: ({ register }) => words.typeText(register) },
          { ...head('unit'), cell: ({ register }) => register.unit },
          { ...head('access'), cell: ({ register }) => words.accesses[register.access] },
          { name: columns.description, cell: (each) => <Details profile={profile} found={each} /> },
          {
            name: words.changes,
            cell: ({ register }) => <Changes register={register} onEdit={onEdit} onRemove={onRemove} />,
          },
        ]}
      />
      {found.length > SHOWN && <p class="said">{words.more(found.length - SHOWN)}</p>}
    </>
  );
}

/** How many requests read a line. */
const requestsOf = (profile: Profile, { register, index }: FoundRegister) =>
  index === undefined && canRead(register) ? readRequests(profile, register).length : 1;

interface RowProps {
  readonly profile: Profile;
  readonly found: FoundRegister;
}

function Details({ profile, found }: RowProps) {
  const words = useWords('devices');
  const { description, names, count } = found.register;
  const requests = requestsOf(profile, found);
  const details = [
    description,
    names.map(({ number, name }) => `${number} ${name}`).join(', '),
    words.scaleText(found.register),
    found.index === undefined && count > 1 ? words.countText(count) : '',
    requests > 1 ? words.readBy(requests) : '',
  ];
  return (
    <>
      {details
        .filter((part) => part !== '')
        .map((part) => (
          <span key={part} class="part">
            {part}
          </span>
        ))}
    </>
  );
}

/** What makes the requests of a line. */
function Requests({ profile, found, onTaken }: RowProps & Pick<RegisterActs, 'onTaken'>) {
  const words = useWords('devices');
  const { register, index } = found;
  const name = foundName(found);
  const take = (make: (...line: Parameters<typeof writeRequest>) => RegisterRequest, requests: number) => {
    step(deviceRequest(draft.value, make(profile, register, index), profile.serial));
    onTaken(words.taken(name, requests));
  };
  return (
    <span class="in-row">
      {canRead(register) && (
        <button
          type="button"
          aria-label={words.readOf(name)}
          onClick={() => take(readWithScale, requestsOf(profile, found))}
        >
          {words.read}
        </button>
      )}
      {canWrite(register) && (
        <button type="button" aria-label={words.writeOf(name)} onClick={() => take(writeRequest, 1)}>
          {words.write}
        </button>
      )}
    </span>
  );
}

/** What changes the map: away from what uses it, and less loud. */
function Changes({ register, onEdit, onRemove }: Pick<FoundRegister, 'register'> & Omit<RegisterActs, 'onTaken'>) {
  const words = useWords('devices');
  return (
    <span class="in-row">
      <button
        type="button"
        class="quiet"
        aria-label={words.editOf(register.name)}
        data-focus={`edit ${register.name}`}
        onClick={() => onEdit(register)}
      >
        {words.edit}
      </button>
      <button type="button" class="quiet" aria-label={words.removeOf(register.name)} onClick={() => onRemove(register)}>
        {words.remove}
      </button>
    </span>
  );
}
