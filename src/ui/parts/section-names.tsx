import type { Section } from '../../modbus/index.ts';
import { useWords } from './words.ts';

/** Where the specification says so. */
export function SectionNames({ of }: { readonly of: Section | readonly Section[] }) {
  const { section } = useWords('page');
  return <span class="section">{[of].flat().map(section).join(', ')}</span>;
}
