/** Written by the build: `scripts/licences.mjs`. */
declare module 'virtual:licences' {
  interface Licence {
    readonly name: string;
    readonly version: string;
    /** Its name in SPDX. */
    readonly licence: string;
    readonly text: string;
  }
  export const ours: Licence;
  export const others: readonly Licence[];
}
