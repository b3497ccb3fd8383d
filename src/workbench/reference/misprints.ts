import type { Section } from '../../modbus/index.ts';

/** How much an error in print matters: bytes or rules are wrong, two readings are possible, or it is only odd. */
export type Gravity = 'wrong' | 'ambiguous' | 'note';

/** An error in the print of a specification. */
export type Misprint =
  | 'coilNumber'
  | 'listenOnlyEvent'
  | 'eventLogCode'
  | 'productCodeOfOne'
  | 'productCodeOfThree'
  | 'numberOfObjects'
  | 'fileResponseLength'
  | 'writeFileLength'
  | 'fifoPointer'
  | 'fifoExample'
  | 'readWriteExample'
  | 'crcCodeOrder'
  | 'crcLabel'
  | 'crcCodeTyping'
  | 'registersOf484'
  | 'serverIdByteCount'
  | 'maskFormula'
  | 'rtuCharacters'
  | 'lrcContents'
  | 'tcpUnit'
  | 'exceptionOrder'
  | 'copiedLimits';

/** The misprints: where they stand, and how much they matter. Each was checked against the bytes and the specification. */
export const misprints: Readonly<
  Record<Misprint, { readonly sections: readonly Section[]; readonly gravity: Gravity }>
> = {
  coilNumber: { sections: ['PI Figure 46'], gravity: 'wrong' },
  listenOnlyEvent: { sections: ['AP 6.10', 'PI p. 41'], gravity: 'wrong' },
  eventLogCode: { sections: ['PI p. 11'], gravity: 'wrong' },
  productCodeOfOne: { sections: ['AP 6.21'], gravity: 'wrong' },
  productCodeOfThree: { sections: ['AP 6.21'], gravity: 'wrong' },
  numberOfObjects: { sections: ['AP 6.21'], gravity: 'ambiguous' },
  fileResponseLength: { sections: ['AP 6.14'], gravity: 'wrong' },
  writeFileLength: { sections: ['AP 6.15', 'AP Figure 25'], gravity: 'wrong' },
  fifoPointer: { sections: ['AP 6.18'], gravity: 'wrong' },
  fifoExample: { sections: ['AP 6.18', 'PI Figure 43'], gravity: 'note' },
  readWriteExample: { sections: ['AP 6.17', 'PI Figure 40'], gravity: 'note' },
  crcCodeOrder: { sections: ['SL 6.2.2'], gravity: 'wrong' },
  crcLabel: { sections: ['SL 6.2.2', 'SL Appendix B'], gravity: 'wrong' },
  crcCodeTyping: { sections: ['PI p. 114'], gravity: 'wrong' },
  registersOf484: { sections: ['PI App. B'], gravity: 'wrong' },
  serverIdByteCount: { sections: ['PI function 17'], gravity: 'ambiguous' },
  maskFormula: { sections: ['PI function 22'], gravity: 'wrong' },
  rtuCharacters: { sections: ['PI RTU framing'], gravity: 'wrong' },
  lrcContents: { sections: ['PI LRC', 'SL 2.5.2.2'], gravity: 'wrong' },
  tcpUnit: { sections: ['TG 4.4.1.2'], gravity: 'ambiguous' },
  exceptionOrder: { sections: ['AP Figure 9', 'AP 6'], gravity: 'ambiguous' },
  copiedLimits: { sections: ['AP 6.3', 'AP 6.6'], gravity: 'note' },
};
