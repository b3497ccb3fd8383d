import type { SentResult, TransactionOutcome, Unsure } from '../../bus/index.ts';
import { decodeFrame, describeFunction, type Reading } from '../../modbus/index.ts';
import type { ReadFailure } from '../../workbench/index.ts';
import { byteHex, fields, plural } from './common.ts';

export const milliseconds = (duration: number) =>
  duration < 10
    ? `${duration.toFixed(1)} ms`
    : duration < 10_000
      ? `${Math.round(duration)} ms`
      : `${(duration / 1000).toFixed(1)} s`;

/** An exception by its code, and what the code is called. */
export const exceptionName = (code: number): string => {
  const known = fields.choices['exceptionCode']?.[code];
  return `exception ${byteHex(code)}${known ? `, ${known.name}` : ''}`;
};

const outcomeNames: { readonly [O in TransactionOutcome['kind']]: string } = {
  reply: 'answered',
  exception: 'refused by the device',
  sent: 'sent; no device answers',
  silent: 'no answer',
  broken: 'the answer is not a valid frame',
  'not-sent': 'the adapter does not accept it',
  lost: 'the adapter is lost',
  cancelled: 'stopped',
};

/** What a request came to, in some words. */
export function outcomeName({ outcome, verdict, unsure }: Pick<SentResult, 'outcome' | 'verdict' | 'unsure'>): string {
  if (unsure) return 'answered, but perhaps not to this request';
  return outcome === 'reply' && verdict === 'bad' ? 'answered, but not as it should be' : outcomeNames[outcome];
}

/** Why a request has no values: the exception by its code, or what became of the request. */
export const failureName = ({ exceptionCode, ...failure }: ReadFailure): string =>
  exceptionCode === undefined || failure.unsure ? outcomeName(failure) : exceptionName(exceptionCode);

/** The device said why it refused a request. */
function refusal({ reply, transport, request }: SentResult): string {
  const code = reply && decodeFrame(reply, { transport, direction: 'response', request }).fields['exceptionCode'];
  if (typeof code !== 'number') return 'The device refused the request.';
  const hint = fields.choices['exceptionCode']?.[code]?.hint;
  return `The device refused the request: ${exceptionName(code)}${hint ? ` (${hint})` : ''}.`;
}

/** A request by its unit and its function: `unit 6, 03 Read Holding Registers`. */
export const requestName = ({ unitId, functionCode = 0 }: Pick<Reading, 'unitId' | 'functionCode'>): string => {
  const name = `${byteHex(functionCode)} ${describeFunction(functionCode, 'request').name}`;
  return unitId === undefined ? name : `unit ${unitId}, ${name}`;
};

/** What came back, and is not a sound reply. */
function brokenReply({ reply = new Uint8Array(), request, transport }: SentResult): string {
  const { outcome } = decodeFrame(reply, { transport, direction: 'response', request });
  return outcome.kind === 'whole'
    ? `A whole reply came back, but its ${transport === 'ascii' ? 'LRC' : 'CRC'} is wrong.`
    : 'Something came back, but it is not a valid frame.';
}

/** What a result says, by its outcome. */
const results: Readonly<Record<SentResult['outcome'], (result: SentResult) => string>> = {
  reply: ({ verdict }) => (verdict === 'good' ? 'Answered.' : 'Answered, but something is wrong with the reply.'),
  exception: refusal,
  sent: () => 'Sent. No device answers this request.',
  silent: ({ request, transport }) =>
    `No device answered: ${requestName(decodeFrame(request, { transport, direction: 'request' }))}.`,
  broken: brokenReply,
  'not-sent': () => 'The request could not be sent: the adapter does not accept it.',
  lost: () => 'The adapter was lost meanwhile.',
  cancelled: () => 'Stopped.',
};

/** What is said of the current frame when it is sent, and of its reply. */
export const send = {
  heading: 'Current frame',
  send: 'Send',
  stop: 'Stop',
  sending: 'Sent, waiting for the reply…',
  noFrame: 'The current frame is not complete: see the Frame view.',
  notRequest: 'This is a reply. Choose Request in the Frame view.',
  notConnected: 'Connect first, to an adapter or to the virtual bus.',
  pdu: 'A bare PDU has no unit and no checksum: choose RTU or ASCII in the Frame view.',
  tcp: 'A page cannot open a TCP connection: browsers let pages speak HTTP and WebSocket only. These commands send the frame from a terminal:',
  change: 'Change it',
  openReply: 'Show the reply',
  replyBytes: 'Bytes of the reply',
  open: 'Open the reply in the Frame view',
  result: (result: SentResult) => {
    const { outcome, echo, unsure } = result;
    if (echo === 'undecided') return 'What came back is the same as the request.';
    if (unsure !== undefined) return 'Answered, but perhaps not to this request.';
    return results[outcome](result);
  },
  unsure: {
    'perhaps-late': 'A request before this one was not answered in time, and this may be its reply. Send it again.',
    'perhaps-copy': 'The same frame came shortly before: this may be a second copy of it. Send it again.',
    'two-replies': 'Two different replies came: two devices may have the same unit number.',
  } satisfies Record<Unsure, string>,
  slow: (took: number, timeout: number) =>
    `The device answers after ${milliseconds(took)}, and the time-out is ${timeout} ms: raise it under Transactions.`,
  took: (duration: number, attempts: number) =>
    `${milliseconds(duration)}${attempts > 1 ? `, ${attempts} attempts` : ''}`,
  echo: {
    removed: 'The adapter returned the request; this echo was removed.',
    undecided:
      'The reply is the same as the request: it may be the adapter’s echo. Say under Transactions whether the adapter echoes.',
    none: '',
  },
  strays: (count: number) => `${plural(count, 'other piece')} came meanwhile: see the log.`,
  lastReply: 'Last reply',
  replyTo: (request: string) => `To: ${request}`,
  noReplyYet: 'The reply to the next request that is sent stands here.',
  show: { reply: 'Show the reply', 'no-answer': 'Find out why' },
  /** Read out behind “No device answered”. */
  stepsOpen: 'Steps to find out why stand in the tab “No answer”.',
};
