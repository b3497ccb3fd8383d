import type { Uses } from '../iec/lower.ts';
import type { Units } from '../iec/units.ts';

/** What IEC 61131-3 has no portable function for: written where a program needs it. */
export function helpers(units: Units, uses: Uses): void {
  if (uses.kinds.has('float')) for (const line of text(units, REAL_OF_BITS)) units.lines.add(line);
  if (uses.kinds.has('floor')) for (const line of text(units, FLOOR)) units.lines.add(line);
}

const text = ({ printer }: Units, lines: string): readonly string[] => {
  const all = ['', ...lines.trim().split('\n')];
  return printer.comments
    ? all
    : all.flatMap((line) => (line.startsWith('(*') ? [] : line.replace(/ *\(\*.*\*\)$/, '')));
};

/** DWORD_TO_REAL copies the bits in some systems, and gives the whole number in others. */
const REAL_OF_BITS = `
(* The number whose IEEE 754 form these 32 bits are. Systems do not agree on what DWORD_TO_REAL does. *)
FUNCTION FC_RealOfBits : LREAL
VAR_INPUT
    Bits : DWORD;
END_VAR
VAR
    Exponent : DINT;
    Mantissa : DINT;
    Magnitude : LREAL;
END_VAR
Exponent := DWORD_TO_DINT(SHR(Bits, 23) AND DWORD#16#000000FF);
Mantissa := DWORD_TO_DINT(Bits AND DWORD#16#007FFFFF);
IF Exponent = 0 THEN
    Exponent := 1;
ELSE
    Mantissa := Mantissa + 8388608;  (* the bit that is not sent *)
END_IF;
Magnitude := DINT_TO_LREAL(Mantissa);
WHILE Exponent > 150 DO
    Magnitude := Magnitude * 2.0;
    Exponent := Exponent - 1;
END_WHILE;
WHILE Exponent < 150 DO
    Magnitude := Magnitude / 2.0;
    Exponent := Exponent + 1;
END_WHILE;
IF (Bits AND DWORD#16#80000000) <> DWORD#16#00000000 THEN
    Magnitude := -Magnitude;
END_IF;
FC_RealOfBits := Magnitude;
END_FUNCTION
`;

/** A conversion to a whole number rounds; TRUNC is not the same in all systems. */
const FLOOR = `
(* The greatest whole number that is not greater. *)
FUNCTION FC_Floor : LREAL
VAR_INPUT
    Number : LREAL;
END_VAR
VAR
    Rounded : LREAL;
END_VAR
Rounded := LINT_TO_LREAL(LREAL_TO_LINT(Number));
IF Rounded > Number THEN
    Rounded := Rounded - 1.0;
END_IF;
FC_Floor := Rounded;
END_FUNCTION
`;
