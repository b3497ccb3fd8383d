import type { Parity, ReceivedCharacter, Receiver, SerialFormat, SerialLine } from '../../modbus/index.ts';

/** Receivers that are set otherwise than the sender; `own` is set by hand. */
export const receiverKinds = ['none', 'parity', 'no-parity', 'data-bits', 'double', 'half', 'swapped', 'own'] as const;
export type ReceiverKind = (typeof receiverKinds)[number];

const otherParity: Readonly<Record<Parity, Parity>> = { none: 'even', even: 'odd', odd: 'even' };

/** How a receiver of a kind is set, beside a sender; `undefined` for no receiver. */
export function receiverLine(kind: ReceiverKind, sender: SerialLine, own: SerialLine): SerialLine | undefined {
  switch (kind) {
    case 'none':
      return undefined;
    case 'parity':
      return { ...sender, parity: otherParity[sender.parity] };
    case 'no-parity':
      return { ...sender, parity: 'none' };
    case 'data-bits':
      return { ...sender, dataBits: sender.dataBits === 8 ? 7 : 8 };
    case 'double':
      return { ...sender, baud: 2 * sender.baud };
    case 'half':
      return { ...sender, baud: sender.baud / 2 };
    case 'swapped':
      return sender;
    case 'own':
      return own;
  }
}

/** The receiver, in the bit times of its sender. */
export function receiverFor(kind: ReceiverKind, sender: SerialLine, line: SerialLine): Receiver {
  const { dataBits, parity, stopBits }: SerialFormat = line;
  return { format: { dataBits, parity, stopBits }, bit: sender.baud / line.baud, inverted: kind === 'swapped' };
}

/** What a receiver made of a frame. */
export interface Reception {
  readonly sent: number;
  readonly received: number;
  /** Characters that have an error. */
  readonly wrong: number;
  /** Whether what was read is what was sent. */
  readonly same: boolean;
}

export function receptionOf(sent: Uint8Array, received: readonly ReceivedCharacter[]): Reception {
  const wrong = received.filter(({ errors }) => errors.length > 0).length;
  const same =
    wrong === 0 && sent.length === received.length && received.every(({ value }, index) => value === sent[index]);
  return { sent: sent.length, received: received.length, wrong, same };
}
