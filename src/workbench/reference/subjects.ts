/** The tables of the reference. */
export type ReferenceSubject =
  | 'functions'
  | 'troubles'
  | 'exceptions'
  | 'subFunctions'
  | 'meiTypes'
  | 'numbering'
  | 'units'
  | 'sizes'
  | 'limits'
  | 'ranges'
  | 'open'
  | 'misprints';
