export {
  type BitKind,
  characterBits,
  type Level,
  parityBit,
  type WireBit,
} from './character.ts';
export {
  edgesOf,
  firstAfter,
  type Gap,
  type Line,
  type LineCharacter,
  type LineFrame,
  type LineTimes,
  lineOf,
  type Quiet,
} from './line.ts';
export { type ReceivedCharacter, type ReceiveError, type Receiver, receive } from './receive.ts';
