import { useState } from 'preact/hooks';
import { decodeFrame, fromHex } from '../../../modbus/index.ts';
import { formatBytes, readOctets } from '../../../notation/index.ts';
import { type Draft, draftOf, requestOf, withForce } from '../../../workbench/index.ts';
import { TextArea } from '../../kit/text-input.tsx';
import { idOf, Labelled } from '../../parts/labelled.tsx';
import { commit, draft, edit, evaluation, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import './bytes-field.css';

/** The bytes of the current frame, typed: the form follows. */
export function BytesField() {
  const words = useWords('page').page.byteField;
  // What is typed here, and the draft it came to: beside any other draft it is out of date.
  const [typed, setTyped] = useState<{ readonly text: string; readonly of: Draft }>();
  const { value: current } = draft;
  const { errors, frame } = evaluation.value;
  const text = typed?.of === current ? typed.text : (current.bytes ?? (frame ? formatBytes(frame.bytes) : ''));
  const error = errors.get('bytes');
  const type = (next: string) => {
    const of = draftFrom(next, draft.value);
    setTyped({ text: next, of });
    edit(of);
  };
  // What was typed is written as everything else is, once it is done.
  const leave = () => {
    setTyped(undefined);
    commit();
  };
  return (
    <div class="bytes-field in-row" onFocusOut={leave}>
      <Labelled path="bytes" label={words.label} hint={words.hint} error={error}>
        <TextArea id={idOf('bytes')} text={text} wrong={error !== undefined} onText={type} />
      </Labelled>
      {frame?.reading.forced['checksum'] !== undefined && (
        <button type="button" onClick={() => step(withForce(draft.value, 'checksum', undefined))}>
          {words.fixChecksum}
        </button>
      )}
    </div>
  );
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
