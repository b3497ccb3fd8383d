import { BytesField } from '../read/bytes-field.tsx';
import { ReadPlace } from '../read/read-place.tsx';
import { Chips } from './chips.tsx';
import './input.css';

/** Where a frame, a log or code is put in. */
export const InputPlace = () => (
  <>
    <ReadPlace />
    <Chips />
    <section class="panel">
      <BytesField />
    </section>
  </>
);
