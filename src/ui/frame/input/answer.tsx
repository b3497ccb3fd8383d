import { addressOf } from '../../../store/index.ts';
import type { InputTool } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';

/** The answer to what the text asks of another view, and the way to that view. */
export function Answer({ tool }: { readonly tool: InputTool }) {
  const { asked } = useWords('read');
  const [answer, href] =
    tool.tool === 'checksum'
      ? [asked.checksum(tool), addressOf('checksum', tool.parts)]
      : tool.tool === 'timing'
        ? [asked.timing(tool), addressOf('timing', tool.parts)]
        : [asked.exception(tool.code), addressOf('reference', { search: asked.codeText(tool.code) })];
  return (
    <p class="in-row">
      {answer} <a href={href}>{asked.open[tool.tool]}</a> <span class="soft">{asked.stays}</span>
    </p>
  );
}
