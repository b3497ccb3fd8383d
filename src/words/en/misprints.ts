import type { Misprint } from '../../workbench/index.ts';

/** What is printed, what is wrong with it, and what is right. */
export interface MisprintWords {
  readonly printed: string;
  readonly kind: string;
  readonly why: string;
  readonly right: string;
}

/** The errors in the print of the specifications. */
export const misprints: Readonly<Record<Misprint, MisprintWords>> = {
  coilNumber: {
    printed: '"coil 1245 (04A1 hex)"',
    kind: 'wrong number in text',
    why: '0x04A1 is 1185 decimal, not 1245 (0x04DD). V1.1b3 §7 prints 1185.',
    right: 'address 0x04A1 = 1185 (coil number 1186 in one-based numbering)',
  },
  listenOnlyEvent: {
    printed: 'event byte 20h "entered Listen Only Mode"',
    kind: 'contradiction',
    why: 'The event-byte definition in the same section gives 04h for "entered listen only mode"; 20h has bits 7 and 6 clear and is not defined.',
    right: '04h = entered listen only mode, 00h = communications restart',
  },
  eventLogCode: {
    printed: 'communications event log cited as function 0B',
    kind: 'wrong function code in text',
    why: '0B is the event counter; the log is 0C.',
    right: '0C',
  },
  productCodeOfOne: {
    printed: 'single-transaction example: object 01 length 0D for "Product code XX"',
    kind: 'wrong object length',
    why: 'The string has 15 characters (16 with the leading blank inside the printed quotes), not 13.',
    right: '0F',
  },
  productCodeOfThree: {
    printed: 'first transaction: object 01 length 1C for " Product code XXXXXXXXXXXXXXXX"',
    kind: 'wrong object length',
    why: '"Product code " is 13 characters, plus 16 X = 29 (1D); with the printed leading blank 30 (1E). 1C (28) fits neither.',
    right: '1D without the leading blank',
  },
  numberOfObjects: {
    printed: 'two-transaction example: Number Of Objects 03 in both responses',
    kind: 'wrong object count',
    why: 'The first response carries two objects and the second one, while the field description says it counts the objects in this response (only the stream total would be 3).',
    right: '02 and 01',
  },
  fileResponseLength: {
    printed: 'File Resp. length 0x07 to 0xF5; Resp. data Length 0x07 to 0xF5',
    kind: 'range contradicts example',
    why: 'The example in the same section has file response length 05; one register needs only 03 (and total 04).',
    right: 'file response length odd, from 03; response data length even, from 04; a PDU of 253 bytes is the bound',
  },
  writeFileLength: {
    printed: 'state diagram tests byte count 0x07..0xF5',
    kind: 'range contradiction',
    why: 'Field table says request data length 0x09..0xFB.',
    right: '0x09..0xFB',
  },
  fifoPointer: {
    printed: 'pointer register "1246 (0x04DE)"',
    kind: 'one-based/zero-based inconsistency',
    why: 'All other examples of V1.1b3 add one (register 108 = address 006B); 0x04DE = 1246 is the PDU address, so the register number would be 1247. PI-MBUS-300 calls the same address 41247.',
    right: 'register 1247 (41247) is address 0x04DE',
  },
  fifoExample: {
    printed: 'FIFO count 2, byte count 06 (V1.1b3)',
    kind: 'different data for the same example',
    why: 'PI-MBUS-300 shows the same query answered with count 3, byte count 08, third value 1322h. Both are self-consistent.',
    right: 'both valid',
  },
  readWriteExample: {
    printed: 'read 0003 / write 000E (V1.1b3)',
    kind: 'different bytes for the same example',
    why: 'PI-MBUS-300 uses read 0004 / write 000F (registers 40005 and 40016). Both consistent with their own text.',
    right: 'both valid',
  },
  crcCodeOrder: {
    printed: 'return (uchCRCHi << 8 | uchCRCLo) documented as already byte-swapped',
    kind: 'wrong byte order in code',
    why: 'Run on 02 07 the code returns 0x1241, the un-swapped register; the note says the CRC is already swapped. Sending the return value high byte first gives the wrong wire order. PI-MBUS-300 code (same tables) returns 0x4112, i.e. swapped.',
    right: 'wire order 41 12 (low byte first)',
  },
  crcLabel: {
    printed: '"4112" labelled most significant first',
    kind: 'wrong label',
    why: 'CRC register for 02 07 is 0x1241; it is transmitted 41 12.',
    right: '0x1241, wire 41 12',
  },
  crcCodeTyping: {
    printed: 'auchCRCHi[uIndex} and *puchMsgg++',
    kind: 'code does not compile',
    why: 'Typing errors in the printed C code (closing brace for bracket, doubled g).',
    right: 'auchCRCHi[uIndex] and *puchMsg++',
  },
  registersOf484: {
    printed: '484 controller: 254 holding registers per read',
    kind: 'impossible maximum',
    why: '508 data bytes do not fit a one-byte byte count nor the 256-byte message limit quoted in the same manual.',
    right: 'at most 125 registers',
  },
  serverIdByteCount: {
    printed: 'Micro 84: byte count 08',
    kind: 'wrong byte count',
    why: 'Only five data bytes (ID, run, three more) are listed.',
    right: '05 according to the listing',
  },
  maskFormula: {
    printed: '(Current AND And_Mask) OR (Or_Mask AND And_Mask)',
    kind: 'formula lost overline',
    why: 'The text layers of the PDF lose the overline over the second And_Mask: read literally the And mask would select the same bits twice.',
    right: '(current AND and) OR (or AND NOT and)',
  },
  rtuCharacters: {
    printed: 'allowable RTU characters 0-9, A-F',
    kind: 'misleading wording',
    why: 'RTU transmits 8-bit binary bytes.',
    right: '0x00..0xFF',
  },
  lrcContents: {
    printed: 'LRC over the contents of the ASCII message field',
    kind: 'misleading wording',
    why: 'It is calculated over the binary bytes (after decoding the hex pairs), without colon and CR LF. Figure 46 confirms.',
    right: 'LRC over decoded bytes: 0A 01 04 A1 00 01 → 4F',
  },
  tcpUnit: {
    printed: 'unit id 0xFF "has to be used" and "recommended", 0 also accepted',
    kind: 'contradiction',
    why: 'Three strengths for one rule.',
    right: 'accept 0x00 and 0xFF for a directly addressed server; send 0xFF',
  },
  exceptionOrder: {
    printed: 'check order of exception 02 and 03',
    kind: 'diagram/diagram contradiction',
    why: 'Figure 9 tests the address before the value, the per-function diagrams test quantity/value (03) before the address (02); FC18 tests 02 first.',
    right: 'accept either when both faults are present',
  },
  copiedLimits: {
    printed: '0x0070 for maximum registers; error code 0x06 for FC06 (in an OCR copy)',
    kind: 'OCR misprint',
    why: 'Maximum is 0x007D; error code is 0x86.',
    right: '0x007D, 0x86',
  },
};
