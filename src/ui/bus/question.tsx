import { Component, createRef } from 'preact';
import { requestsOf } from '../../bus/index.ts';
import { decodeFrame, type SerialMode } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { Question as Asked } from '../../store/index.ts';
import { words as pageWords } from '../parts/page-words.ts';
import { bus } from './bus.ts';
import { busWords as words } from './bus-words.ts';

/** Requests shown of a job. */
const SHOWN = 12;

/** Asks whether a request is to be sent. Escape is no. */
export class Question extends Component<{ readonly question: Asked }> {
  private readonly dialog = createRef<HTMLDialogElement>();

  override componentDidMount() {
    this.dialog.current?.showModal();
  }

  render() {
    const { command, why } = this.props.question;
    const requests = command.kind === 'send' ? [command.request] : requestsOf(command.order);
    const { transport } = bus.state.rules;
    const units = new Set(requests.map((request) => unitOf(request, transport)));
    return (
      <dialog
        ref={this.dialog}
        aria-labelledby="question-title"
        onCancel={(event) => {
          event.preventDefault();
          bus.answer(false);
        }}
      >
        <h2 id="question-title">{words.guard.title}</h2>
        <p>{words.guard.doubt(why, [...units])}</p>
        <ul class="asked">
          {requests.slice(0, SHOWN).map((request, index) => (
            <li key={index}>
              {pageWords.page.summary(
                decodeFrame(request, { transport, direction: 'request' }),
                request.length,
                transport,
              )}
              <br />
              <span class="mono">{formatBytes(request)}</span>
            </li>
          ))}
          {requests.length > SHOWN && <li>{words.guard.more(requests.length - SHOWN)}</li>}
        </ul>
        <div class="actions">
          <button type="button" onClick={() => bus.answer(false)}>
            {words.guard.no}
          </button>
          <button type="button" class="first" onClick={() => bus.answer(true)}>
            {words.guard.yes}
          </button>
        </div>
      </dialog>
    );
  }
}

const unitOf = (request: Uint8Array, transport: SerialMode) =>
  decodeFrame(request, { transport, direction: 'request' }).unitId;
