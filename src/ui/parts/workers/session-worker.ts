import { makeClock, portsLike, Session, type SessionCommand, WebSerialLink } from '../../../bus/index.ts';
import { sayAlive } from './worker-alive.ts';

/** The session works here, because a window that is hidden runs its timers once a second or once a minute. */
const scope = globalThis as unknown as Worker;
const clock = makeClock();

const session = new Session({
  clock,
  tell: (news) => scope.postMessage(news),
  async portLink(choice) {
    const [port] = 'serial' in navigator ? await portsLike(navigator.serial, choice) : [];
    return port && new WebSerialLink(port, clock);
  },
});

addEventListener('message', ({ data }: MessageEvent<SessionCommand>) => void session.take(data));
sayAlive();
