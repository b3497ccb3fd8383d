import { SourceNotePlace } from '../examples/shelf.tsx';
import { BytesField } from '../read/bytes-field.tsx';
import { ReadPlace } from '../read/read-place.tsx';

/** Where a frame, a log or code is put in. */
export const InputPlace = () => (
  <>
    <ReadPlace />
    <section class="panel">
      <BytesField />
      <SourceNotePlace />
    </section>
  </>
);
