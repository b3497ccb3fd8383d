/** The most characters that a name may have which a person gives. */
export const LONGEST_NAME = 200;

/** A name as it is kept: no blanks around it, and no runs of them. */
export const plainName = (name: string): string => name.trim().replace(/\s+/g, ' ');

/** The name, or where it is taken the name with the first number that is free: “Pump (2)”. */
export function freeName(name: string, taken: { has(name: string): boolean }): string {
  if (!taken.has(name)) return name;
  const stem = name.replace(/ \(\d+\)$/, '');
  let number = 2;
  while (taken.has(`${stem} (${number})`)) number++;
  return `${stem} (${number})`;
}
