import { ModbusRTU } from 'modbus-webserial';
import { defaultRules, defaultSettings, lineTimes } from '../../src/bus/index.ts';

/** Read holding registers 0 to 9 of unit 1. */
const REQUEST = Uint8Array.of(0x01, 0x03, 0x00, 0x00, 0x00, 0x0a, 0xc5, 0xcd);
const QUANTITY = 10;
const REPLY_LENGTH = 25;
/** The server's last register. */
const LAST_VALUE = 1009;
/** Milliseconds, before anything is counted. */
const WARM_UP = 1000;

let port;
document.querySelector('button').onclick = async () => {
  port = await navigator.serial.requestPort();
  document.title = 'chosen';
};

/** When each transaction ended that counts, in milliseconds. */
const warmed = (times) => times.filter((time) => time > times[0] + WARM_UP);

/** A poll without pauses in the session of the page, in its worker. `gap` takes the place of the rules' silence. */
async function ours({ baud, gap, seconds }) {
  const worker = new Worker(new URL('../../src/ui/parts/workers/session-worker.ts', import.meta.url), {
    type: 'module',
  });
  const times = [];
  let lines = 0;
  let wrong = 0;
  const waiting = new Map();
  const until = (kind) => new Promise((resolve) => waiting.set(kind, resolve));
  worker.onmessage = ({ data }) => {
    if (data.kind === 'state') waiting.get(data.state.kind)?.(data.state);
    if (data.kind === 'job-ended') waiting.get('job-ended')?.();
    if (data.kind === 'lines') for (const line of data.lines) if (line.verdict === 'good') lines++;
    if (data.kind === 'jobs') {
      for (const { news } of data.news) {
        times.push(news.time);
        if (news.verdict !== 'good' || news.reply.length !== REPLY_LENGTH) wrong++;
      }
    }
  };
  worker.postMessage({ kind: 'set-rules', rules: { ...defaultRules, ...(gap !== undefined && { gap }) } });
  const opened = until('open');
  worker.postMessage({ kind: 'open-port', port: port.getInfo(), settings: { ...defaultSettings, baud } });
  await opened;
  const order = { kind: 'poll', requests: [REQUEST], interval: 0 };
  worker.postMessage({ kind: 'start-job', id: 1, order, confirmed: false });
  await new Promise((resolve) => setTimeout(resolve, WARM_UP + 1000 * seconds));
  const ended = until('job-ended');
  worker.postMessage({ kind: 'stop-job', id: 1 });
  await ended;
  const closed = until('closed');
  worker.postMessage({ kind: 'close' });
  await closed;
  worker.terminate();
  if (wrong > 0 || lines !== times.length) throw new Error(`${wrong} of ${times.length} are wrong, ${lines} logged`);
  return warmed(times);
}

async function modbusWebserial({ baud, seconds }) {
  // It asks for a port each time; the one that was chosen is given to it.
  navigator.serial.requestPort = () => Promise.resolve(port);
  const client = await ModbusRTU.openWebSerial({ baudRate: baud, parity: 'even' });
  client.setID(1);
  const times = [];
  for (const end = performance.now() + WARM_UP + 1000 * seconds; performance.now() < end; ) {
    const { data } = await client.readHoldingRegisters(0, QUANTITY);
    if (data.length !== QUANTITY || data.at(-1) !== LAST_VALUE) throw new Error(`read ${data}`);
    times.push(performance.now());
  }
  await client.close();
  return warmed(times);
}

/**
 * How long a transaction takes at least by the rules, in milliseconds: the characters of both frames, and the silence before
 * the next request (SL 2.5.1.1). The server answers at once.
 */
function least({ baud }) {
  const { characters, gap } = lineTimes({ ...defaultSettings, baud }, defaultRules);
  return characters(REQUEST.length + REPLY_LENGTH) + gap;
}

Object.assign(globalThis, { ours, modbusWebserial, least });
