import { useEffect, useMemo } from 'preact/hooks';
import { LARGEST_MAP, MapImport } from '../../../store/index.ts';
import type { MapSource } from '../../../workbench/index.ts';
import { allDevices } from '../device/chosen.ts';
import { useWords } from '../words.ts';
import { mapReader } from './map-reader.ts';

/**
 * An import of one's own, and what reads a file or a text for it: `undefined`, which is said, if that cannot be read. That a file is
 * read is said until something else is.
 */
export function useMapImport(say: (line: string) => void) {
  const words = useWords('library');
  const mapImport = useMemo(() => new MapImport(allDevices, mapReader), []);
  useEffect(() => mapImport.close, []);
  const sourceOf = async (what: File | string): Promise<MapSource | undefined> => {
    if (typeof what === 'string') return { name: words.pastedName, content: what };
    if (what.size > LARGEST_MAP) {
      say(words.tooBig);
      return undefined;
    }
    say(words.reading(what.name));
    const content = await what.arrayBuffer().catch(() => undefined);
    if (content === undefined) say(words.unread);
    return content && { name: what.name, content: new Uint8Array(content) };
  };
  return { mapImport, sourceOf };
}
