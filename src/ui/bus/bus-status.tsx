import { busLink } from '../parts/bus-link.ts';
import { useWords } from '../parts/words.ts';

/** How the line stands, in the header of every view; nothing while there is none. */
export function BusStatus() {
  const said = useWords('bus').linkShort(busLink.value);
  return said && <small role="status">{said}</small>;
}
