import type { FrameInput } from '../../modbus/index.ts';
import { quoted } from './c-like.ts';
import { javascriptLibrary, serialSettings, wherePart } from './javascript-library.ts';
import { exchangeParts } from './javascript-shell.ts';
import { isAnswered, pauseOf, SILENCE } from './shell.ts';

const IDENTIFIER = /^[A-Za-z_]\w*$/;
/** The shortest list that takes lines of its own. */
const LONG = 60;

/** A value as JavaScript writes it: what is `undefined` is left out, numbers of bytes are hexadecimal in no place. */
function literal(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(literal).join(', ')}]`;
  if (typeof value === 'string') return quoted(value);
  if (value === null || typeof value !== 'object') return String(value);
  const entries = Object.entries(value)
    .filter(([, one]) => one !== undefined)
    .map(([name, one]) => `${IDENTIFIER.test(name) ? name : quoted(name)}: ${literal(one)}`);
  return entries.length === 0 ? '{}' : `{ ${entries.join(', ')} }`;
}

/** A frame's input, a line for each of its parts. */
function inputText(input: FrameInput): string {
  const { transport, direction, unitId, transactionId, functionCode, fields, force } = input;
  const forced = force === undefined || Object.keys(force).length === 0 ? undefined : force;
  const parts = { transport, direction, unitId, transactionId, functionCode, fields, force: forced };
  const lines = Object.entries(parts).flatMap(([name, value]) =>
    value === undefined ? [] : [`  ${name}: ${literal(value)},`],
  );
  return lines.join('').length < LONG ? literal(parts) : `{\n${lines.join('\n')}\n}`;
}

const SHOW = (transport: string) => `
/** Prints what a reply says; gives whether it is good. */
function show(about, request, reply) {
  const { outcome, fields, problems } = decodeFrame(reply, { transport: "${transport}", direction: "response", request });
  const errors = problems.filter(({ severity }) => severity === "error").map(({ code }) => code);
  if (reply.length === 0) errors.push("no-reply");
  else if (outcome.kind !== "whole") errors.push(outcome.kind);
  console.log(about, errors.length > 0 ? errors.join(", ") : JSON.stringify(fields));
  return errors.length === 0 && fields.exceptionCode === undefined;
}
`;

/** How many bytes the whole reply has, told from what is there. */
const WANTED = (transport: string) => `
/** How long the whole reply is, or what must be there before more can be said; 0 if only silence ends it. */
function wantedFor(request) {
  return (reply) => {
    const { outcome, open } = decodeFrame(reply, { transport: "${transport}", direction: "response", request });
    if (outcome.kind === "short") return reply.length + outcome.missing;
    return open ? 0 : reply.length;
  };
}
`;

export const framewright = javascriptLibrary({
  id: 'framewright',
  name: 'framewright',
  transports: ['rtu', 'ascii', 'tcp'],
  parts: ['exchange'],
  install: ({ transport }) => (transport === 'tcp' ? 'framewright' : 'framewright serialport'),
  head: (plan) => {
    const isTcp = plan.transport === 'tcp';
    const answered = plan.requests.some(isAnswered);
    const settings = isTcp
      ? ''
      : `
const LINE = ${serialSettings(plan)};
const PAUSE = ${pauseOf(plan.options)}; // milliseconds of silence between two frames
${answered ? `const SILENCE = ${SILENCE}; // milliseconds of silence that end a reply of unknown length\n` : ''}`;
    return `
${answered || isTcp ? 'import { once } from "node:events";\n' : ''}${isTcp ? 'import { connect } from "node:net";\n' : 'import { setTimeout as sleep } from "node:timers/promises";\n'}import { fileURLToPath } from "node:url";
import { ${answered ? 'decodeFrame, ' : ''}encodeFrame } from "framewright";
${isTcp ? '' : 'import { SerialPort } from "serialport";\n'}
${wherePart(plan)}${settings.trimEnd()}${answered || isTcp ? `\nconst TIMEOUT = ${plan.options.timeout}; // milliseconds` : ''}`;
  },
  shared: ({ transport, options: { echo }, requests }) => {
    const answered = requests.some(isAnswered);
    const parts = exchangeParts(transport === 'tcp', echo, answered);
    return answered ? [...parts, WANTED(transport), SHOW(transport)] : parts;
  },
  constant: ({ input }) => `encodeFrame(${inputText(input)})`,
  request: (request, frame) =>
    isAnswered(request)
      ? `const reply = await exchange(client, ${frame}, wantedFor(${frame}));
return show(${quoted(`${request.about}:`)}, ${frame}, reply);`
      : `await send(client, ${frame});
return true;`,
  offline: (frames) => `if (given[0] === "--bytes") {
${frames.map((frame) => `  console.log(Buffer.from(${frame}).toString("hex"));`).join('\n')}
  return 0;
}`,
  open: (given) => `const client = await open(${given});`,
  close: ({ transport }) => (transport === 'tcp' ? 'client.destroy();' : 'await done((next) => client.close(next));'),
});
