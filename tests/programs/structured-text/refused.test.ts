import { describe, expect, test } from 'vitest';
import { Machine } from './machine.ts';

/** A program that is taken: in each test one thing in it is changed for one that strict compilers refuse. */
const GOOD = `
TYPE
    T_Frame : ARRAY[0..7] OF BYTE;
END_TYPE

(* The CRC of the first bytes. *)
FUNCTION FC_Crc : WORD
VAR_INPUT
    Count : DINT;
END_VAR
VAR_IN_OUT
    Bytes : T_Frame;
END_VAR
VAR
    Crc : WORD;
    Index : DINT;
    Turn : DINT;
END_VAR
VAR CONSTANT
    POLYNOMIAL : WORD := WORD#16#A001;
END_VAR
Crc := WORD#16#FFFF;
FOR Index := 0 TO Count - 1 DO
    Crc := Crc XOR BYTE_TO_WORD(Bytes[Index]);
    FOR Turn := 1 TO 8 DO
        IF (Crc AND WORD#16#0001) <> WORD#16#0000 THEN
            Crc := SHR(Crc, 1) XOR POLYNOMIAL;
        ELSE
            Crc := SHR(Crc, 1);
        END_IF;
    END_FOR;
END_FOR;
FC_Crc := Crc;
END_FUNCTION

FUNCTION_BLOCK FB_Send
VAR_INPUT
    Execute : BOOL;
    Address : WORD := WORD#16#02AB;
END_VAR
VAR_OUTPUT
    Sent : DINT;
    Frame : T_Frame;
END_VAR
VAR
    Wait : TON;
    Stage : DINT;
END_VAR
Wait(IN := Stage = 1, PT := T#20ms);
CASE Stage OF
    0:
        IF Execute THEN
            Frame[0] := WORD_TO_BYTE(SHR(Address, 8));
            Frame[1] := WORD_TO_BYTE(Address AND WORD#16#00FF);
            Frame[2] := WORD_TO_BYTE(FC_Crc(Count := 2, Bytes := Frame));
            Stage := 1;
        END_IF;
    1:
        IF Wait.Q THEN
            Sent := Sent + 1;
            Stage := 0;
        END_IF;
END_CASE;
END_FUNCTION_BLOCK
`;

const changed = (from: string, to: string): string => {
  expect(GOOD).toContain(from);
  return GOOD.replace(from, () => to);
};

describe('a strict compiler', () => {
  test('takes the program, which calculates', () => {
    const machine = new Machine(GOOD);
    // The example of SL, appendix B: 02 07 is followed by 41 12.
    expect(machine.call('FC_Crc', 2, [0x02, 0x07, 0, 0, 0, 0, 0, 0])).toBe(0x1241);
    expect(machine.call('FC_Crc', 0, [0x02, 0x07, 0, 0, 0, 0, 0, 0])).toBe(0xffff);
  });

  test('counts time in cycles', () => {
    const machine = new Machine(GOOD);
    const block = machine.instance('FB_Send');
    const sent: unknown[] = [];
    for (machine.now = 0; machine.now <= 60; machine.now += 10) {
      block.cycle({ Execute: true });
      sent.push(block.get('Sent'));
    }
    // The first cycle starts it, the second starts the timer, and 20 ms later it has run out.
    expect(sent).toEqual([0, 0, 0, 1, 1, 1, 1]);
    expect(block.get('Frame')).toEqual([0x02, 0xab, expect.any(Number), 0, 0, 0, 0, 0]);
  });

  test.each<[what: string, rule: string, from: string, to: string]>([
    ['>>', 'no operator >>', 'SHR(Crc, 1) XOR', 'Crc >> 1 XOR'],
    ['!=', 'no operator !=', '<> WORD#16#0000', '!= WORD#16#0000'],
    ['==', 'no operator ==', 'Stage = 1,', 'Stage == 1,'],
    ['a comment with //', 'a comment begins with (*', '(* The CRC of the first bytes. *)', '// The CRC'],
    ['a comment in a comment', 'a comment in a comment', 'The CRC of', 'The (* CRC *) of'],
    ['WORD XOR BYTE', 'WORD XOR BYTE', 'BYTE_TO_WORD(Bytes[Index])', 'Bytes[Index]'],
    ['a literal without a type beside a WORD', 'WORD AND DINT', 'Crc AND WORD#16#0001', 'Crc AND 1'],
    ['a literal without a type in a WORD', 'DINT where WORD stands', 'Crc := WORD#16#FFFF', 'Crc := 65535'],
    ['a literal of another type', 'DWORD where WORD stands', 'WORD#16#FFFF', 'DWORD#16#FFFF'],
    ['a literal out of range', 'out of range', 'WORD#16#FFFF', 'WORD#16#1FFFF'],
    [
      'a number that is narrowed by itself',
      'WORD where BYTE stands',
      'WORD_TO_BYTE(SHR(Address, 8))',
      'SHR(Address, 8)',
    ],
    ['a conversion from another type', 'BYTE where DINT stands', 'BYTE_TO_WORD(', 'DINT_TO_WORD('],
    [
      'a conversion that systems do not agree on',
      'no such conversion in all systems',
      'BYTE_TO_WORD(Bytes[Index])',
      'LREAL_TO_WORD(BYTE_TO_LREAL(Bytes[Index]))',
    ],
    [
      'a WORD as a condition',
      'WORD where BOOL stands',
      'IF (Crc AND WORD#16#0001) <> WORD#16#0000 THEN',
      'IF Crc AND WORD#16#0001 THEN',
    ],
    ['a number as a truth', 'DINT where BOOL stands', 'IF Execute THEN', 'IF Stage THEN'],
    ['a sum of words', '+ of WORD', 'Crc := Crc XOR', 'Crc := Crc +'],
    ['a shift of a number', 'SHR of bits', 'SHR(Address, 8)', 'DINT_TO_WORD(SHR(WORD_TO_DINT(Address), 8))'],
    ['an index outside the array', 'outside the array', 'Frame[2]', 'Frame[8]'],
    ['an index that is no number', 'WORD where DINT stands', 'Bytes[Index]', 'Bytes[Crc]'],
    ['an element of what is no array', 'not an array', 'Bytes[Index]', 'Index[Index]'],
    ['what is not declared', 'not declared', 'Sent := Sent + 1', 'Gone := Sent + 1'],
    ['what is not used', 'not used', 'Turn : DINT;', 'Turn : DINT;\n    Spare : DINT;'],
    ['an output that is never set', 'not used', 'Sent : DINT;', 'Sent : DINT;\n    Error : BOOL;'],
    ['a name twice', 'a name twice', 'Turn : DINT;', 'TURN : DINT;\n    Turn : DINT;'],
    ['a variable called as its function', 'a name twice', 'Turn : DINT;', 'Fc_crc : DINT;'],
    ['a keyword as a name', 'a name that the language keeps', 'Count : DINT;', 'Step : DINT;'],
    ['a standard function as a name', 'a name that the language keeps', 'Count : DINT;', 'Len : DINT;'],
    ['a name of one letter that Instruction List has', 'a name that the language keeps', 'Count : DINT;', 'R : DINT;'],
    ['a type as a name', 'a name that the language keeps', 'Count : DINT;', 'Bit : DINT;'],
    ['two underlines', 'underlines in a row or at an end', 'POLYNOMIAL : WORD', 'THE__POLYNOMIAL : WORD'],
    ['an underline at the end', 'underlines in a row or at an end', 'POLYNOMIAL : WORD', 'POLYNOMIAL_ : WORD'],
    ['a constant that is set', 'a constant stays', 'FC_Crc := Crc', 'POLYNOMIAL := Crc; FC_Crc := Crc'],
    ['a constant without a value', 'a constant has a value', 'POLYNOMIAL : WORD := WORD#16#A001', 'POLYNOMIAL : WORD'],
    ['an input that is set', 'an input stays', 'FC_Crc := Crc', 'Count := 0; FC_Crc := Crc'],
    ['a function without a result', 'a function gives something', 'FC_Crc := Crc;', ''],
    [
      'a variable of a loop that is set',
      'the variable of a loop stays',
      'Crc := Crc XOR',
      'Index := Index + 1; Crc := Crc XOR',
    ],
    ['one variable for two loops', 'a loop has a variable of its own', 'FOR Turn := 1', 'FOR Index := 1'],
    [
      'a loop that counts words',
      'WORD where DINT stands',
      'FOR Turn := 1 TO 8',
      'FOR Crc := WORD#16#0001 TO WORD#16#0008',
    ],
    [
      'a parameter that is missing',
      'all parameters are given',
      'FC_Crc(Count := 2, Bytes := Frame)',
      'FC_Crc(Bytes := Frame)',
    ],
    [
      'an array of another type',
      'ARRAY FRAME where T_FRAME stands',
      'Frame : T_Frame;',
      'Frame : ARRAY[0..7] OF BYTE;',
    ],
    ['a value where a variable is passed', 'a variable is passed', 'Bytes := Frame)', 'Bytes := Frame[0])'],
    [
      'a timer without a time',
      'a timer has two inputs',
      'Wait(IN := Stage = 1, PT := T#20ms)',
      'Wait(IN := Stage = 1)',
    ],
    ['a number as a time', 'DINT where TIME stands', 'T#20ms', '20'],
    ['a block without a statement', 'a block without a statement', 'Crc := SHR(Crc, 1);\n        END_IF', 'END_IF'],
    ['an END_IF without a semicolon', '; is missing', 'END_IF;', 'END_IF'],
    [
      'constants before variables',
      'variables come before constants',
      'VAR CONSTANT\n    POLYNOMIAL : WORD := WORD#16#A001;\nEND_VAR\n',
      'VAR CONSTANT\n    POLYNOMIAL : WORD := WORD#16#A001;\nEND_VAR\nVAR\n    More : DINT;\nEND_VAR\n',
    ],
    ['a label twice', 'a label twice', '    1:\n', '    0:\n'],
    [
      'a function without a parameter',
      'a function has a parameter',
      'FUNCTION_BLOCK FB_Send',
      'FUNCTION FC_One : DINT\nFC_One := 1;\nEND_FUNCTION\n\nFUNCTION_BLOCK FB_Send',
    ],
    [
      'a function that is called before it is declared',
      'not declared before',
      'FUNCTION FC_Crc',
      'FUNCTION FC_Early : WORD\nVAR_IN_OUT\n    Bytes : T_Frame;\nEND_VAR\nFC_Early := FC_Crc(Count := 1, Bytes := Bytes);\nEND_FUNCTION\n\nFUNCTION FC_Crc',
    ],
  ])('refuses %s', (_, rule, from, to) => {
    expect(() => new Machine(changed(from, to))).toThrow(expect.objectContaining({ rule }));
  });

  test('finds an index outside the array when it runs, also where only one side of an AND is asked for', () => {
    const machine = new Machine(
      changed('(Crc AND WORD#16#0001) <> WORD#16#0000', 'Index < 8 AND Bytes[Index + 7] = BYTE#16#00'),
    );
    expect(() => machine.call('FC_Crc', 2, [1, 2, 3, 4, 5, 6, 7, 8])).toThrow(RangeError);
  });
});
