/** Something said of rows. */
export interface Told<Code extends string> {
  readonly code: Code;
  readonly rows: readonly number[];
  readonly [data: string]: unknown;
}

/** Gathers what is said of rows, one entry for each kind. */
export class Tally<Code extends string> {
  private readonly kinds = new Map<
    string,
    { readonly code: Code; readonly rows: Set<number>; readonly data: Readonly<Record<string, unknown>> | undefined }
  >();

  /** `data` tells kinds of one code apart: which question, which column. */
  add(code: Code, rows: Iterable<number>, data?: Readonly<Record<string, unknown>>): void {
    const key = `${code} ${JSON.stringify(data)}`;
    const kind = this.kinds.get(key) ?? { code, rows: new Set<number>(), data };
    this.kinds.set(key, kind);
    for (const row of rows) kind.rows.add(row);
  }

  /** In the order in which each kind was met first. */
  list(): readonly Told<Code>[] {
    return Array.from(this.kinds.values(), ({ code, rows, data }) => ({
      ...data,
      code,
      rows: [...rows].sort((a, b) => a - b),
    }));
  }
}
