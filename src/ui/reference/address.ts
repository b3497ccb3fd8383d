/** The part of the address of the reference from `#`; a search follows behind `?`. */
export const REFERENCE = '#reference';
