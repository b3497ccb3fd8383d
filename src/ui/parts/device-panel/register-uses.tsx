import {
  canRead,
  canWrite,
  deviceUnit,
  type FoundRegister,
  type Profile,
  type Register,
  type RegisterRequest,
  readRequests,
  readWithScale,
  writeRequest,
} from '../../../devices/index.ts';
import { deviceRequest, foundName } from '../../../workbench/index.ts';
import { draft, step } from '../store.ts';
import { useWords } from '../words.ts';

/** What is done with the registers of a device; they are named by their place in its list. */
export interface RegisterActs {
  /** The request for a register is the current frame; the sentence says so below its form. */
  readonly onTaken: (name: string, sentence: string) => void;
  /** Reads a register on the bus; without it, Read makes a request. */
  readonly onRead?: ((found: FoundRegister) => void) | undefined;
  readonly onKeep: (at: number, register: Register) => void;
  readonly onRemove: (at: number) => void;
}

/** How many requests read a line. */
const requestsOf = (profile: Profile, { register, index }: FoundRegister) =>
  index === undefined && canRead(register) ? readRequests(profile, register).length : 1;

interface RequestsProps extends Pick<RegisterActs, 'onTaken' | 'onRead'> {
  readonly profile: Profile;
  readonly found: FoundRegister;
  readonly tabIndex: number;
}

/** What makes the requests of a line, or reads it. */
export function Requests({ profile, found, tabIndex, onTaken, onRead }: RequestsProps) {
  const words = useWords('devices');
  const { register, index } = found;
  const name = foundName(found);
  const take = (make: (...line: Parameters<typeof writeRequest>) => RegisterRequest, requests: number) => {
    step(deviceRequest(draft.value, make(profile, register, index), deviceUnit(profile)));
    onTaken(name, words.taken(name, requests));
  };
  const button = (text: string, label: string, act: () => void) => (
    <button type="button" data-stop="" tabIndex={tabIndex} aria-label={label} onClick={act}>
      {text}
    </button>
  );
  return (
    <span class="in-row">
      {canRead(register) &&
        button(words.read, words.readOf(name), () =>
          onRead ? onRead(found) : take(readWithScale, requestsOf(profile, found)),
        )}
      {canWrite(register) && button(words.write, words.writeOf(name), () => take(writeRequest, 1))}
    </span>
  );
}

interface ChangesProps {
  readonly register: Register;
  readonly tabIndex: number;
  readonly isOpen: boolean;
  readonly onOpen: () => void;
}

/** What opens the fields that have no column: away from what uses the register, and less loud. */
export function Changes({ register, tabIndex, isOpen, onOpen }: ChangesProps) {
  const words = useWords('devices');
  return (
    <button
      type="button"
      class="quiet"
      data-stop=""
      tabIndex={tabIndex}
      aria-label={words.editOf(register.name)}
      aria-expanded={isOpen}
      onClick={onOpen}
    >
      {words.edit}
    </button>
  );
}
