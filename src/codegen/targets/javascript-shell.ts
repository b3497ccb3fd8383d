/** The parts of a JavaScript program that no frame changes: how it speaks over a line, and how it says what came of it. */

const OPEN_SERIAL = `
/** Waits for a call that tells the function it is given when it has ended. */
function done(call) {
  return new Promise((resolve, reject) => {
    call((error) => (error ? reject(error) : resolve()));
  });
}

/** Opens the port. */
async function open(path) {
  const line = new SerialPort({ path, ...LINE, autoOpen: false });
  await done((next) => line.open(next));
  return line;
}

/** Sends a request, after the silence that parts it from what was sent before. */
export async function send(line, request) {
  await sleep(PAUSE);
  // What came before belongs to nothing.
  await done((next) => line.flush(next));
  line.read();
  line.write(request);
  await done((next) => line.drain(next));
}
`;

const OPEN_TCP = `
/** Connects to the server. */
async function open(host) {
  const line = connect({ host, port: PORT, noDelay: true });
  await once(line, "connect", { signal: AbortSignal.timeout(TIMEOUT) });
  return line;
}

/** Sends a request. */
export async function send(line, request) {
  line.read(); // What came before belongs to nothing.
  line.write(request);
}
`;

const RECEIVE = `
/** Bytes that come within so many milliseconds; none, if nothing comes. */
async function receive(line, within) {
  const waiting = line.read();
  if (waiting !== null) return waiting;
  try {
    await once(line, "readable", { signal: AbortSignal.timeout(within) });
  } catch (error) {
    if (error.name !== "AbortError") throw error;
  }
  return line.read() ?? Buffer.alloc(0);
}
`;

const ECHO = `
  // The adapter gives back what is sent.
  while (reply.length < request.length) {
    const more = await receive(line, Math.max(0, Math.ceil(deadline - performance.now())));
    if (more.length === 0) break;
    reply = Buffer.concat([reply, more]);
  }
  if (reply.subarray(0, request.length).equals(request)) reply = reply.subarray(request.length);`;

const exchangePart = (isTcp: boolean, echo: boolean) => `
/** Sends a request and gives what comes back, when all of it is there or the time is over. */
export async function exchange(line, request, wanted) {
  await send(line, request);
  const deadline = performance.now() + TIMEOUT;
  let reply = Buffer.alloc(0);${echo ? ECHO : ''}
  for (;;) {
    const length = wanted(reply);
    if (${isTcp ? '' : 'length > 0 && '}reply.length >= length) return reply;
    const left = Math.max(0, Math.ceil(deadline - performance.now()));
${
  isTcp
    ? '    const more = await receive(line, left);'
    : `    // Where no byte says how long the reply is, silence ends it.
    const more = await receive(line, length === 0 && reply.length > 0 ? Math.min(left, SILENCE) : left);`
}
    if (more.length === 0) return reply;
    reply = Buffer.concat([reply, more]);
  }
}
`;

/** Comments that take lines of their own. */
const REMARK = /^\s*(\/\/.*|\/\*\*.*\*\/)$/;

/** The lines of a part; without comments, if there are to be none. */
export const partLines = (part: string, comments: boolean): readonly string[] => {
  const lines = part.trim().split('\n');
  return comments ? lines : lines.filter((line) => !REMARK.test(line)).map((line) => line.replace(/; \/\/ .*$/, ';'));
};

/** How the program speaks over the line; `answered` says whether any reply is waited for. */
export const exchangeParts = (isTcp: boolean, echo: boolean, answered: boolean): readonly string[] => [
  isTcp ? OPEN_TCP : OPEN_SERIAL,
  ...(answered ? [RECEIVE, exchangePart(isTcp, echo)] : []),
];

export const VERDICT = `
/** Says in words what a check gives. */
function verdict(result) {
  if (result > 0) return \`exception \${result}: \${exceptionName(result)}\`;
  if (result < 0) return \`fault \${result}: \${faultName(result)}\`;
  return "good";
}
`;

export const WAIT_UNTIL = `
/** Asks every interval whether something holds, and gives up after the time-out; both in milliseconds. */
async function waitUntil(holds, interval, timeout) {
  const begin = performance.now();
  for (let due = begin + interval; !(await holds()); due += interval) {
    if (due > begin + timeout) return false;
    await sleep(Math.max(0, due - performance.now()));
  }
  return true;
}
`;
