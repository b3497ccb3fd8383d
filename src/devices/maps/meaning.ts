/** What a column of a foreign table is taken for. */
export const meanings = [
  'name',
  /** Another name of the same register: in another language, or a technical id. */
  'other-name',
  'group',
  'description',
  /** As sent, or as the file counts; the question `counting` says which. */
  'address',
  /** As the manual prints it: 40001. */
  'number',
  /** The last address of the value. */
  'end',
  'table',
  'function',
  'access',
  'type',
  'order',
  /** How many registers, bytes or bits the value takes. */
  'words',
  'bytes',
  'bit-size',
  /** How many values follow each other. */
  'count',
  'factor',
  'divisor',
  /** The power of ten of the factor. */
  'exponent',
  /** The name or the address of the register that holds the exponent. */
  'scale-register',
  'offset',
  'decimals',
  'unit',
  'names',
  'range',
  'minimum',
  'maximum',
  'bit',
  'mask',
  /** The number that says that there is no value. */
  'not-implemented',
  /** The models that have the register. */
  'model',
  /** Counts the rows. */
  'index',
  /** Left alone. */
  'other',
] as const;
export type Meaning = (typeof meanings)[number];

/** Why a column was taken for its meaning. */
export const columnReasons = [
  /** Its header says so, and its cells agree. */
  'header',
  /** Its cells say so; the header says nothing, or something else. */
  'cells',
  /** A person has said so. */
  'answer',
  /** It differs from the other column of numbers by one. */
  'pair',
  /** Its texts are the most different ones. */
  'texts',
  /** Nothing is known of it. */
  'unknown',
] as const;
export type ColumnReason = (typeof columnReasons)[number];

/** A column of the file. */
export interface MapColumn {
  readonly header: string;
  readonly meaning: Meaning;
  readonly why: ColumnReason;
}

/** Of these meanings a table has one column; of the others it may have several. */
export const isSingle = (meaning: Meaning): boolean =>
  !['other-name', 'description', 'names', 'model', 'other', 'index'].includes(meaning);
