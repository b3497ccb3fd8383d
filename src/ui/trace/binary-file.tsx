import { useEffect, useState } from 'preact/hooks';
import { isBinary, otherFile } from '../../captures/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { pasted } from '../parts/pasted.ts';
import { useWords } from '../parts/words.ts';

/** Bytes by which a file is told from a text. */
const BEGINNING = 4096;
/** Bytes that are shown as a frame: as many as RTU frames have at most. */
const FRAME = 256;

/**
 * Says at once that a file is no text: its bytes are read as what a serial line carried, and the first of them can be shown as
 * a frame.
 */
export function BinaryFile({ file }: { readonly file: File }) {
  const words = useWords('trace');
  const [beginning, setBeginning] = useState<Uint8Array | undefined>();
  useEffect(() => {
    let gone = false;
    const take = (bytes: ArrayBuffer) => gone || setBeginning(new Uint8Array(bytes));
    // A file that cannot be read is said to be so by what reads all of it.
    file
      .slice(0, BEGINNING)
      .arrayBuffer()
      .then(take, () => undefined);
    return () => {
      gone = true;
    };
  }, [file]);
  if (beginning === undefined || !isBinary(beginning)) return null;
  const first = beginning.subarray(0, FRAME);
  return (
    <>
      <span role="status">{words.binary(file.name, file.size, otherFile(beginning))}</span>
      <button type="button" onClick={() => pasted.take(formatBytes(first))}>
        {words.binaryAsFrame(first.length, file.size)}
      </button>
    </>
  );
}
