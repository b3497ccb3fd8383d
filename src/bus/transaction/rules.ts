import {
  ASCII_SILENCE,
  bitsPerCharacter,
  charactersTime,
  MOST_ASCII,
  MOST_RTU,
  rtuSilences,
  type SerialLine,
  type SerialMode,
} from '../../modbus/index.ts';

/** Whether the adapter gives back what is sent, as many on two wires do. `auto` finds out. */
export type EchoRule = 'auto' | 'on' | 'off';

/** How transactions are carried out. Times are milliseconds. */
export interface TransactionRules {
  readonly transport: SerialMode;
  /** From the end of the request until the reply must have begun (SL 2.4.1). */
  readonly timeout: number;
  /** How often a request is sent again that got no reply, or a broken one. */
  readonly retries: number;
  /** The silence before a request; if absent, what the speed asks for (SL 2.5.1.1). */
  readonly gap?: number | undefined;
  /** The silence after a broadcast, in which devices do what they were told (SL 2.4.1). */
  readonly turnaround: number;
  readonly echo: EchoRule;
  /**
   * After a time-out the line is left quiet until the late reply has come, at most for one more time-out, if it could answer
   * the next request. Without this, more replies are doubtful.
   */
  readonly quiet: boolean;
  /** No reply comes after its time-out, as on the virtual bus, so that no reply is doubtful. */
  readonly punctual: boolean;
  /**
   * A shorter silence proves nothing: adapters hand bytes over in lumps, 16 ms with FTDI's, and computers are busy. This is
   * waited for only if a frame is cut off, or does not tell how long it is.
   */
  readonly patience: number;
}

export const defaultRules: TransactionRules = {
  transport: 'rtu',
  timeout: 1000,
  retries: 0,
  turnaround: 100,
  echo: 'auto',
  quiet: true,
  punctual: false,
  patience: 200,
};

/** The rules as times on a line of this speed and format, in milliseconds. */
export interface LineTimes {
  /** How long a number of characters takes. */
  characters(number: number): number;
  /** The silence between two frames. */
  readonly gap: number;
  /** The silence after which nothing more comes. */
  readonly silence: number;
  /** The longest that a frame can take. */
  readonly longest: number;
}

const MICROSECONDS = 1000;

export function lineTimes(line: SerialLine, { transport, gap, patience }: TransactionRules): LineTimes {
  const ascii = transport === 'ascii';
  const characters = (number: number) => charactersTime(line, number) / MICROSECONDS;
  const t35 = rtuSilences(line.baud, bitsPerCharacter(line)).t35 / MICROSECONDS;
  return {
    characters,
    gap: gap ?? (ascii ? 0 : t35),
    silence: ascii ? ASCII_SILENCE / MICROSECONDS : t35 + patience,
    longest: characters(ascii ? MOST_ASCII : MOST_RTU),
  };
}
