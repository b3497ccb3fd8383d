/**
 * The listing of "Modbus RTU for PLC Implementation, Complete Guide", which does not compile, and what a strict compiler says of
 * its lines. Found with matiec and by the third edition of IEC 61131-3 (2013).
 * @module
 */

/** Why a line is refused, or does not do what its comment says. */
export const guideFaults = {
  /** Comments that begin with `//` came with the third edition: matiec, OpenPLC's compiler, refuses them. */
  comment: { refused: true, section: '6.1.5' },
  /** Structured Text has no operator `>>`: SHR shifts. */
  'shift-operator': { refused: true, section: '7.3.2, table 71' },
  /** AND, XOR and SHR take bits (BYTE, WORD), no numbers (UINT). */
  'bits-of-number': { refused: true, section: '6.6.2.5, tables 29 and 30' },
  /** A BYTE is not made a WORD, nor bits a number, beside one: BYTE_TO_WORD does it. */
  'mixed-types': { refused: true, section: '6.6.1.6' },
  /** Its comment promises a rising edge; the frame is built in every cycle as long as it is TRUE. */
  'no-edge': { refused: false, section: '' },
  /** The output is never set. */
  'never-set': { refused: false, section: '' },
  /** Once TRUE, it stays so. */
  'never-reset': { refused: false, section: '' },
} as const satisfies Readonly<Record<string, { readonly refused: boolean; readonly section: string }>>;

export type GuideFault = keyof typeof guideFaults;

/** Its lines, each with what is wrong with it. Of the comments, only the first is marked. */
export const guideListing: readonly (readonly [line: string, fault?: GuideFault])[] = [
  ['FUNCTION_BLOCK FB_ModbusWrite'],
  ['VAR_INPUT'],
  ['    SlaveID : BYTE;           // WEG address (usually 6)', 'comment'],
  ['    Register : UINT;          // Register number (e.g., 683)'],
  ['    Value : UINT;             // Value to write'],
  ['    Execute : BOOL;           // Trigger on rising edge'],
  ['END_VAR'],
  [''],
  ['VAR_OUTPUT'],
  ['    Done : BOOL;              // TRUE when complete'],
  ['    Error : BOOL;             // TRUE if error', 'never-set'],
  ['    TxBuffer : ARRAY[0..7] OF BYTE;  // Frame to send'],
  ['END_VAR'],
  [''],
  ['VAR'],
  ['    CRC : UINT;'],
  ['    i : INT;'],
  ['    j : INT;'],
  ['END_VAR'],
  [''],
  ['// Build Modbus frame'],
  ['IF Execute THEN', 'no-edge'],
  ['    // Byte 0: Slave ID'],
  ['    TxBuffer[0] := SlaveID;'],
  ['    '],
  ['    // Byte 1: Function code'],
  ['    TxBuffer[1] := 16#06;  // Write Single Register'],
  ['    '],
  ['    // Byte 2-3: Register address (big endian)'],
  ['    TxBuffer[2] := UINT_TO_BYTE(Register >> 8);      // High byte', 'shift-operator'],
  ['    TxBuffer[3] := UINT_TO_BYTE(Register AND 16#FF); // Low byte', 'bits-of-number'],
  ['    '],
  ['    // Byte 4-5: Value (big endian)'],
  ['    TxBuffer[4] := UINT_TO_BYTE(Value >> 8);         // High byte', 'shift-operator'],
  ['    TxBuffer[5] := UINT_TO_BYTE(Value AND 16#FF);    // Low byte', 'bits-of-number'],
  ['    '],
  ['    // Calculate CRC'],
  ['    CRC := 16#FFFF;'],
  ['    '],
  ['    FOR i := 0 TO 5 DO  // First 6 bytes'],
  ['        CRC := CRC XOR TxBuffer[i];', 'mixed-types'],
  ['        '],
  ['        FOR j := 0 TO 7 DO'],
  ['            IF (CRC AND 16#0001) = 1 THEN', 'bits-of-number'],
  ['                CRC := SHR(CRC, 1) XOR 16#A001;', 'bits-of-number'],
  ['            ELSE'],
  ['                CRC := SHR(CRC, 1);', 'bits-of-number'],
  ['            END_IF;'],
  ['        END_FOR;'],
  ['    END_FOR;'],
  ['    '],
  ['    // Byte 6-7: CRC (little endian!)'],
  ['    TxBuffer[6] := UINT_TO_BYTE(CRC AND 16#FF);      // Low byte first', 'bits-of-number'],
  ['    TxBuffer[7] := UINT_TO_BYTE(CRC >> 8);           // High byte second', 'shift-operator'],
  ['    '],
  ['    Done := TRUE;', 'never-reset'],
  ['END_IF;'],
  [''],
  ['END_FUNCTION_BLOCK'],
];
