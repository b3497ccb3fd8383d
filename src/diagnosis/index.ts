export type { DiagnoseContext } from './case.ts';
export { diagnose } from './diagnose.ts';
export type { Confidence, Finding, FindingCode, FindingData } from './finding.ts';
export { type ConversationChunk, type ConversationItem, readConversation } from './identity/conversation.ts';
export { type IdentifyContext, type Identity, identify } from './identity/identify.ts';
export type { Reason, ReasonCode, ReasonData } from './identity/reason.ts';
export { type Segment, splitStream } from './split-stream.ts';
