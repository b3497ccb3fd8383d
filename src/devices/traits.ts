/** In what a device departs from the specification. */
export type Trait = (typeof traits)[number];
export const traits = [
  /** A value of 32 or 64 bits is counted as one address, and sent whole (Enron, Daniel). */
  'one-address-each-value',
  /** 05 sets a coil with any first byte but 0 (AP 6.5 allows FF 00 and 00 00 only). */
  'any-value-is-on',
  /** The byte count of 0F is 1 + n/8: one more than in AP 6.11 if n is a multiple of 8. */
  'byte-count-plus-one',
] as const;

/** A device, or what else has traits. */
interface Departing {
  readonly traits: readonly Trait[];
}

/** Whether each value has one address, however many registers it takes. */
export const countsValues = ({ traits: own }: Departing): boolean => own.includes('one-address-each-value');

/** Whether any first byte but 0 sets a coil. */
export const takesAnyOn = ({ traits: own }: Departing): boolean => own.includes('any-value-is-on');

/** Whether a value of 05 that AP 6.5 does not allow sets a coil of the device. */
export const isOwnOn = (device: Departing, value: number): boolean => takesAnyOn(device) && value >>> 8 !== 0;

/** The byte count that a device wants in a request 0F for a number of coils (AP 6.11: n/8, rounded up). */
export const coilByteCount = (quantity: number, { traits: own }: Departing): number =>
  own.includes('byte-count-plus-one') ? 1 + Math.floor(quantity / 8) : Math.ceil(quantity / 8);
