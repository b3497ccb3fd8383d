import type { LinkSettings, Refusal } from '../../bus/index.ts';
import type { Reading } from '../../modbus/index.ts';
import type { NoAnswerStep, StepFinding, StepState } from '../../workbench/index.ts';
import { bus } from './bus.ts';
import { all } from './common.ts';
import { duration, scan } from './scan.ts';
import { requestName } from './sent.ts';

export interface StepWords {
  /** The question that the step answers. */
  readonly question: (unit: number | undefined) => string;
  /** What is done, or what to look at. */
  readonly how: string;
  /** On the button that does it; of a step that is looked at by hand, that it was looked at. */
  readonly button: string;
}

const itself = (unit: number | undefined) => (unit === undefined ? 'the device' : `unit ${unit}`);

const steps: Readonly<Record<NoAnswerStep, StepWords>> = {
  unit: {
    question: (unit) => `Is there ${unit === undefined ? 'such a unit' : `a unit ${unit}`}?`,
    how: 'Each unit from 1 to 247 is asked for one register. Nothing is changed.',
    button: 'Try units 1–247',
  },
  line: {
    question: () => 'Do speed and parity agree?',
    how: 'The unit is asked for one register at the usual speeds and formats. The port is opened again with each, and at the end as it was.',
    button: 'Try speeds and formats',
  },
  echo: {
    question: () => 'Does the adapter send, and does its echo hide the reply?',
    how: 'The request is sent once more, and nothing that comes is taken for an echo.',
    button: 'Look for an echo',
  },
  gap: {
    question: (unit) => `Does ${itself(unit)} need more time?`,
    how: 'The request is sent behind 100 ms of silence, then once more with 5 s for the reply. A device drops a request whose bytes come with gaps between them: adapters and gateways can tear long requests.',
    button: 'Give it time',
  },
  length: {
    question: () => 'Is the request too long?',
    how: 'Half as much is read from the same address. Nothing is written.',
    button: 'Read half',
  },
  wires: {
    question: () => 'Are wires A and B exchanged?',
    how: 'What one maker calls A, another calls B: D0 goes to D0, and D1 to D1. Exchanging them harms nothing. The common wire is the third.',
    button: 'Wires are right',
  },
  termination: {
    question: () => 'Is the line terminated?',
    how: '120 Ω at each of the two ends and nowhere else: without power, 60 Ω between the wires. One place on the line gives it a bias.',
    button: 'Termination is right',
  },
  power: {
    question: (unit) => `Has ${itself(unit)} power?`,
    how: 'Look at its lamps, and whether its serial port is switched on, set to Modbus RTU or ASCII, and is the port that the wires go to.',
    button: 'It has power',
  },
};

const findings: {
  readonly [C in StepFinding['code']]: (finding: Extract<StepFinding, { code: C }>) => string;
} = {
  'unit-answers': ({ unit }) =>
    `Unit ${unit} answers when it is asked for one register. Speed and wires are right; it does not answer this request.`,
  'others-answer': ({ unit, units }) =>
    `${units.length === 1 ? 'Unit' : 'Units'} ${all(units)} ${units.length === 1 ? 'answers' : 'answer'}, unit ${unit} does not: use another number, or look at how the device is set.`,
  'none-answers': ({ asked }) => `None of ${asked} units answers: the number alone is not the cause.`,
  'line-answers': ({ settings }) => `It answers at ${scan.line(settings)}, as the line is.`,
  'other-line-answers': ({ settings }) => `It answers at ${scan.line(settings)}.`,
  'lines-silent': ({ tried, notOpened }) =>
    `It answers at none of ${tried} speeds and formats.${notOpened > 0 ? ` The port did not open with ${notOpened} of them.` : ''}`,
  returned: () => 'The request came back, and no reply behind it: the adapter sends, and its echo hides nothing.',
  'returned-as-reply': () =>
    'The request came back. Its reply has the same bytes, so this is an echo or the reply: try it with a request that reads.',
  'answers-behind-echo': () => 'The request came back, and the reply behind it: it answers now.',
  'nothing-returned': () =>
    'Nothing came back, not even the request: the adapter has no echo, or it does not send. Look at its lamp.',
  'answers-unfiltered': () => 'It answers if no echo is removed: under Transactions, say that the adapter has none.',
  'answers-after-silence': () => 'It answers behind a longer silence: leave more time between requests.',
  'answers-late': () => 'It answers if it is waited for longer: raise the time-out under Transactions.',
  'answers-half': () => 'It answers if half as much is read: ask for less at a time.',
  'still-silent': () => 'Still no reply.',
  garbled: () => 'Something came back that is not a sound reply: look at speed, parity, wires and termination.',
  'gateway-answers': () =>
    'A gateway answers that the device behind it does not (exception 0A or 0B): look at the line behind the gateway.',
  stopped: ({ done, total }) => `Stopped after ${done} of ${total}.`,
  checked: () => 'You have looked at it.',
  'ruled-out': ({ by }) => `What “${steps[by].button}” has found rules this out.`,
};

/** What is looked at when no device answers. */
export const noAnswer = {
  heading: (request: Pick<Reading, 'unitId' | 'functionCode'> | undefined, isAsked: boolean) => {
    if (request === undefined) return 'No device answers';
    return isAsked ? `No device answered: ${requestName(request)}` : `If no device answers: ${requestName(request)}`;
  },
  intro:
    'Each step can exclude a cause or find it; silence alone excludes none. “Read only” and the questions before a write hold here too.',
  noRequest: 'The current frame is not a request that can be sent here: choose one in the Frame view.',
  steps,
  states: {
    open: 'open',
    running: 'running',
    tried: 'tried, still open',
    excluded: 'excluded',
    found: 'found',
  } satisfies Record<StepState, string>,
  time: (milliseconds: number) => `at most ${duration(milliseconds)}`,
  progress: (done: number, total: number, left: number) =>
    `${done} of ${total}${done < total ? `, ${duration(left)} left` : ''}`,
  finding: (finding: StepFinding): string => (findings[finding.code] as (finding: StepFinding) => string)(finding),
  stop: 'Stop',
  use: (settings: LinkSettings) => `Connect with ${scan.line(settings)}`,
  impossible: 'This request cannot be shorter.',
  notConnected: bus.send.notConnected,
  busy: 'Another scan is running: see the Scan tab.',
  otherRuns: 'Another step is running: stop it first, or wait for its end.',
  refused: (why: Refusal) => bus.guard.refusals[why],
  picture: {
    right: 'Right: each wire at the same mark on both sides',
    exchanged: 'Exchanged: nobody understands anybody',
    adapter: 'adapter',
    device: 'device',
    wires: ['D0, A or −', 'D1, B or +', 'common, GND'],
  },
};
