/**
 * A table by name that has no names but its own. In an object as it is written every text such as `constructor` finds
 * something, because every object inherits it.
 *
 * @__NO_SIDE_EFFECTS__
 */
export const dictionary = <T>(own: Readonly<Record<string, T>>): Readonly<Record<string, T>> =>
  Object.assign(Object.create(null), own);
