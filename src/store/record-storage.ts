/**
 * Records by key in a storage that answers later, as IndexedDB does. Each call may be refused; an error whose name speaks of a
 * quota means that the storage is full.
 */
export interface RecordStorage {
  keys(): Promise<readonly string[]>;
  /** `undefined` if there is none. */
  get(key: string): Promise<unknown>;
  set(key: string, record: unknown): Promise<void>;
  delete(key: string): Promise<void>;
  /** Tells other tabs that a record was changed. */
  tell(key: string): void;
  /** Calls `told` with the key of each record that another tab has changed. */
  listen(told: (key: string) => void): void;
  /** Runs `act` while no other tab runs one, where the browser can see to that. */
  alone(act: () => Promise<void>): Promise<void>;
  /** A text that no other call answers, in this tab or in another. */
  unique(): string;
}
