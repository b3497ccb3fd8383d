export { type ByteStep, CrcSteps, type ShiftStep, type SplitShift } from './crc-steps.ts';
export { LrcSteps } from './lrc-steps.ts';
export { checkPrinted, type PrintedExample, type PrintedShift, type PrintedVerdict, wegExample } from './printed.ts';
export { type ReceiverCheck, receiverCheck, sentBytes } from './receiver.ts';
export { type RegisterForm, registerForm } from './register.ts';
export { type TwoTableStep, type TwoTables, twoTableStep, twoTables } from './two-tables.ts';
