const WITH_UNIT = /^[-+−]?\d+(?:[.,]\d+)?\s*([^\d\s.,:;_#/=~…–+-]\S*)$/;
/** Digits of hexadecimal, the `h` behind them, and the `x` of a number that is not finished. */
const HEXADECIMAL = /^(?:[\da-f/]*h?|x.*)$/i;

/** The unit of a text that is one value with a unit (`45 Hz`); `undefined` for any other text, also if the letters may be digits. */
export function unitOf(text: string): string | undefined {
  const unit = WITH_UNIT.exec(text.trim())?.[1];
  return unit === undefined || HEXADECIMAL.test(unit) ? undefined : unit;
}
