export { type Clock, makeClock } from './clock.ts';
export { type Doubt, mayChange, type Permission, permissionFor, type Refusal, readOnlyCodes } from './guard.ts';
export { type JobNews, type JobOrder, requestsOf } from './jobs/index.ts';
export type { PollOrder, PollSample } from './jobs/poll.ts';
export type { ReadNews, ReadOrder } from './jobs/read.ts';
export {
  isFailure,
  type SequenceEnd,
  type SequenceNews,
  type SequenceOrder,
  type StepOutcome,
} from './jobs/sequence.ts';
export type { Trial, TrialNews, TrialOrder } from './jobs/trials.ts';
export { type Adapter, adapterOf, type PortChoice } from './link/adapters.ts';
export {
  choosePort,
  type Port,
  type Ports,
  portsLike,
  rememberedPorts,
  serialSupport,
} from './link/choose.ts';
export {
  defaultSettings,
  type InputSignals,
  isSameLine,
  type LineError,
  type LineErrorCounts,
  type Link,
  type LinkEvent,
  type LinkSettings,
  type LinkState,
  lineErrors,
  noErrors,
  type OutputSignals,
  type WorkerEnd,
} from './link/link.ts';
export { WebSerialLink } from './link/web-serial-link.ts';
export type { HeardCount, HeardNews, ListenOrder } from './listen/heard.ts';
export { type HeardPiece, StreamSplitter } from './listen/stream-splitter.ts';
export type { LogLine } from './log/line.ts';
export {
  DEFAULT_GAP,
  itemsOf,
  type Place,
  type Plan,
  type PlannedRead,
  type PlanRules,
  planReads,
  requestFor,
  type Wanted,
} from './plan.ts';
export { MOST_CELLS, MOST_ROUNDS, Samples } from './samples.ts';
export { estimateScan, type ScanEstimate } from './scan/estimate.ts';
export { addFinding, countFindings, isFound, supports } from './scan/findings.ts';
export type { AddressScan, FunctionScan, ScanOrder, UnitScan } from './scan/order.ts';
export type { ScanAnswer, ScanFinding, ScanNews } from './scan/scan-news.ts';
export type { SentResult, SessionCommand, SessionNews } from './session/messages.ts';
export { Session, type SessionParts } from './session/session.ts';
export { Statistics } from './statistics.ts';
export { mbpollCommand, ncCommand } from './tcp-commands.ts';
export { BusClient, type BusEvent, type Transaction } from './transaction/bus-client.ts';
export { fits } from './transaction/find-frame.ts';
export type {
  Attempt,
  Outcome as TransactionOutcome,
  Stage,
  Stray,
  TransactionResult,
  Unsure,
  Verdict,
} from './transaction/result.ts';
export { defaultRules, type EchoRule, type LineTimes, lineTimes, type TransactionRules } from './transaction/rules.ts';
export { VirtualBench } from './virtual/bench.ts';
export type { HeardBy, HeardFrame, VirtualNews, VirtualOrder, WatchedCells } from './virtual/bench-messages.ts';
export { type CellRange, Cells } from './virtual/cells.ts';
export type { CounterName } from './virtual/counters.ts';
export { counterNames } from './virtual/counters.ts';
export {
  type CellRun,
  type DeviceSetup,
  type ModelName,
  modelNames,
  profileOf,
  serverFor,
  sourceServers,
  sourceSetups,
} from './virtual/devices.ts';
export type { Fault, FaultRule } from './virtual/faults.ts';
export { PortServer } from './virtual/port-server.ts';
export { type Heard, type ServerParts, type SilenceReason, VirtualServer } from './virtual/server.ts';
export { VirtualBus, type VirtualBusEvent, type VirtualBusSettings } from './virtual/virtual-bus.ts';
export { VirtualLink } from './virtual/virtual-link.ts';
