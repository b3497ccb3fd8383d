import { useSteady } from '../../parts/steady.ts';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import './address-ways.css';

/** Both readings of an address that may be a manual's number, while nobody has said which: the other is one click away. */
export function OpenReadings({ path }: { readonly path: string }) {
  const words = useWords('tools').addresses;
  const open = useSteady(() => page.openReading(path), [path]).value;
  if (open === undefined) return null;
  const { typed, table, taken } = open;
  return (
    <fieldset class="open-reading" data-severity="warning">
      <legend class="problem">{words.twoReadings(typed)}</legend>
      {(['number', 'address'] as const).map((which) => (
        <button key={which} type="button" aria-pressed={which === taken} onClick={() => page.settle(path, which)}>
          {which === 'number' ? words.asNumber(table, open.number) : words.asAddress(open.address)}
        </button>
      ))}
    </fieldset>
  );
}
