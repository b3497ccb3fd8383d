import { effect, signal } from '@preact/signals';
import { makeClock, Session, serialSupport, WebSerialLink } from '../../bus/index.ts';
import { Bus, KeptLog } from '../../store/index.ts';
import { busLink, openBus } from '../parts/bus-link.ts';
import { line } from '../parts/line.ts';
import { storage } from '../parts/store.ts';
import { traceView } from '../parts/trace-view.ts';
import { startWorker } from '../parts/workers/start-worker.ts';

busLink.value = serialSupport(window) ?? busLink.value;

/** Raised when a row of the log has become the current frame. */
export const rowChosen = signal(0);

/** Shows the log of the bus. */
export const busTrace = traceView(() => {
  rowChosen.value++;
});

/** The bus of this window. */
export const bus = new Bus<SerialPort>({
  link: busLink,
  serial: 'serial' in navigator ? navigator.serial : undefined,
  inWorker: (tell, ended) => startWorker('session', tell, ended),
  inWindow(port, tell) {
    const clock = makeClock();
    let told = tell;
    const session = new Session({
      clock,
      portLink: () => Promise.resolve(new WebSerialLink(port, clock)),
      tell: (news) => told(news),
    });
    return {
      post: (command) => void session.take(command),
      end() {
        told = () => undefined;
      },
    };
  },
  line,
  trace: busTrace,
  storage,
});

openBus.value = bus;

const kept = new KeptLog(bus.log, () => sessionStorage);
addEventListener('pagehide', kept.keep);
// A tab that is hidden may be ended without another word.
document.addEventListener('visibilitychange', kept.keep);

const askBeforeLeaving = (event: BeforeUnloadEvent): void => event.preventDefault();
effect(() => {
  if (!bus.works.value) return;
  addEventListener('beforeunload', askBeforeLeaving);
  return () => removeEventListener('beforeunload', askBeforeLeaving);
});
