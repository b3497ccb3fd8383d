import { Component } from 'preact';
import { decodeFrame, fromHex } from '../../../modbus/index.ts';
import { formatBytes, readOctets } from '../../../notation/index.ts';
import { type Draft, draftOf, type Evaluation, requestOf, withForce } from '../../../workbench/index.ts';
import { TextArea } from '../../kit/text-input.tsx';
import { idOf, Labelled } from '../../parts/labelled.tsx';
import { commit, edit, evaluation, step } from '../../parts/store.ts';
import { readWords as words } from './read-words.ts';

interface BytesProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** What is typed here, and the draft it came to: beside any other draft it is out of date. */
interface Typed {
  readonly text: string;
  readonly of: Draft;
}

/** The bytes of the current frame, typed: the form follows. */
export class BytesField extends Component<BytesProps, { typed: Typed | undefined }> {
  private readonly type = (text: string) => {
    const of = draftFrom(text, this.props.draft);
    this.setState({ typed: { text, of } });
    edit(of);
  };

  /** What was typed is written as everything else is, once it is done. */
  private readonly leave = () => {
    this.setState({ typed: undefined });
    commit();
  };

  render() {
    const { draft, frame } = this.props;
    const { typed } = this.state;
    const { errors } = evaluation.value;
    const text = typed?.of === draft ? typed.text : (draft.bytes ?? (frame ? formatBytes(frame.bytes) : ''));
    const error = errors.get('bytes');
    return (
      <div class="bytes-field" onFocusOut={this.leave}>
        <Labelled path="bytes" label={words.bytes} hint={words.bytesHint} error={error}>
          <TextArea id={idOf('bytes')} text={text} wrong={error !== undefined} onText={this.type} />
        </Labelled>
        {frame?.reading.forced['checksum'] !== undefined && (
          <button type="button" onClick={() => step(withForce(draft, 'checksum', undefined))}>
            {words.fixChecksum}
          </button>
        )}
      </div>
    );
  }
}

/** The draft of bytes as typed, read as the draft before it was. */
function draftFrom(text: string, before: Draft): Draft {
  const octets = readOctets(text);
  const bytes = octets === undefined ? undefined : fromHex(octets);
  if (bytes === undefined) return { ...before, bytes: text };
  const request = requestOf(before);
  const direction = before.kind === 'request' ? 'request' : 'response';
  return draftOf(decodeFrame(bytes, { transport: before.transport, direction, request }), request);
}
