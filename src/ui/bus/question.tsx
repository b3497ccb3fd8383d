import { Component, createRef } from 'preact';
import { decodeFrame } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { words as pageWords } from '../language.ts';
import { type Question as Asked, bus } from './bus.ts';
import { busWords as words } from './language.ts';

/** Asks whether a request is to be sent. Escape is no. */
export class Question extends Component<{ readonly question: Asked }> {
  private readonly dialog = createRef<HTMLDialogElement>();

  override componentDidMount() {
    this.dialog.current?.showModal();
  }

  render() {
    const { request, why } = this.props.question;
    const { transport } = bus.state.rules;
    const reading = decodeFrame(request, { transport, direction: 'request' });
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
        <p>{words.guard.doubt(why, reading.unitId)}</p>
        <p>{pageWords.page.summary(reading, request.length, transport)}</p>
        <p class="mono">{formatBytes(request)}</p>
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
