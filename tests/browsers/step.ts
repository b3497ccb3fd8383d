import type { Driver } from './driver.ts';

/** What a step may use besides the page. */
export interface Around {
  /** Writes a file for the step, and says where it is. */
  readonly file: (name: string, content: string | Uint8Array) => string;
  /** The page that is one file, as an address of the disk. */
  readonly oneFile: string;
  /** Serves the page anew, at an address of its own, until it is stopped; what is refused comes later. */
  readonly serve: (how?: {
    readonly refused: ReadonlySet<string>;
  }) => Promise<{ readonly address: string; readonly close: () => void }>;
}

export interface Step {
  readonly name: string;
  /** Whether `npm test` runs it; `npm run browsers` runs all. */
  readonly always?: true;
  readonly run: (page: Driver, around: Around) => Promise<void>;
}

export const LINK = '#rtu/request?unitId=6&functionCode=6&address=683&value=4096';

/** Three exchanges: a value, a refusal, and a reply whose last bit is wrong. */
export const LOG = `10:00:00.000 Tx 06 03 02 A9 00 01 54 25
10:00:00.004 Rx 06 03 02 10 00 00 44
10:00:01.000 Tx 01 03 00 6B 00 02 B5 D7
10:00:01.210 Rx 01 83 02 C0 F1
10:00:02.000 Tx 06 03 02 A9 00 01 54 25
10:00:02.004 Rx 06 03 02 10 00 00 45
`;
