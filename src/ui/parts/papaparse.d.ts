/** What is used of papaparse. Its published types bring those of Node along, which the page does not have. */
declare module 'papaparse' {
  interface Step {
    readonly data: readonly string[];
    readonly errors: readonly { readonly type: string }[];
    /** Where the row ends in the text. */
    readonly meta: { readonly cursor: number };
  }
  interface ParseConfig {
    readonly delimiter: string;
    readonly step: (row: Step) => void;
  }
  const papa: {
    parse(text: string, config: ParseConfig): void;
  };
  // biome-ignore lint/style/noDefaultExport: what the package exports.
  export default papa;
}
