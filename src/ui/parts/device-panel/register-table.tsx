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
import { Table } from '../../kit/table.tsx';
import { draft, step } from '../store.ts';
import { useWords } from '../words.ts';

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
      <Table
        class="device-table"
        label={words.table}
        narrow="scroll"
        rows={found.slice(0, SHOWN)}
        keyOf={nameOf}
        columns={[
          { name: columns.name, cell: nameOf },
          { name: columns.number, class: 'mono', cell: (each) => words.number(...numberOf(profile, each)) },
          { name: columns.type, cell: ({ register }) => words.typeText(register) },
          { name: columns.unit, cell: ({ register }) => register.unit },
          { name: columns.access, cell: ({ register }) => words.accesses[register.access] },
          { name: columns.description, cell: (each) => <Details profile={profile} found={each} /> },
          { name: words.actions, cell: (each) => <Actions profile={profile} found={each} {...acts} /> },
        ]}
      />
      {found.length > SHOWN && <p class="said">{words.more(found.length - SHOWN)}</p>}
    </>
  );
}

const nameOf = ({ register, index }: FoundRegister) =>
  index === undefined ? lineName(register) : valueName(register, index);

/** The number that the manual prints, and the address. */
function numberOf(profile: Profile, { register, index = 0 }: FoundRegister): [printed: string, address: number] {
  const address = register.address + index * stepOf(register, profile);
  return [printedNumber(profile.convention, register.table, address), address];
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

function Actions({ profile, found, onTaken, onEdit, onRemove }: RowProps & Omit<TableProps, 'found'>) {
  const words = useWords('devices');
  const { register, index } = found;
  const name = nameOf(found);
  const take = (make: (...line: Parameters<typeof readRequest>) => RegisterRequest, requests: number) => {
    step(deviceRequest(draft.value, make(profile, register, index), profile.serial));
    onTaken(words.taken(name, requests));
  };
  return (
    <span class="in-row">
      {canRead(register) && (
        <button
          type="button"
          aria-label={words.readOf(name)}
          onClick={() => take(readRequest, requestsOf(profile, found))}
        >
          {words.read}
        </button>
      )}
      {canWrite(register) && (
        <button type="button" aria-label={words.writeOf(name)} onClick={() => take(writeRequest, 1)}>
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
  );
}
