import {
  diagnosticSubFunctions,
  type FunctionCode,
  functionCodes,
  functionOf,
  type Layout,
  meiTypes,
} from '../../modbus/index.ts';
import { layoutAfter, problemsOf, type ReferenceFrame, sectionOfProblem } from '../../workbench/index.ts';
import { codeCell, type Entry, frameLink, type Say, sectionCell } from './entry.tsx';
import { digits, layoutCell } from './layout.tsx';

type Texts = ReferenceFrame['texts'];

/** Every public function code. */
export const functionEntries = (say: Say): readonly Entry[] =>
  functionCodes.map((description) => functionEntry(description, say));

function functionEntry(description: FunctionCode, say: Say): Entry {
  const { text, page } = say;
  const { code, name, section, table, broadcast, serialOnly, request, response } = description;
  const texts = { functionCode: code };
  return {
    key: String(code),
    codes: [code],
    also: text.groups[description.group],
    cells: [
      codeCell(text.code(code)),
      <>
        {frameLink({ texts }, name)}
        {serialOnly && <small class="badge">{text.serialOnly}</small>}
      </>,
      table ? page.tables[table].many : <span class="soft">{text.noTable}</span>,
      broadcast ? <b>{text.yes}</b> : <span class="soft">{text.no}</span>,
      bothWays({ request, response, texts, digits: text.code(code), name, before: digits(code), say }),
      sectionCell(say, section),
    ],
  };
}

interface BothWays {
  readonly request: Layout;
  readonly response: Layout;
  readonly texts: Texts;
  /** The code and the name of what is shown, for the names of the links. */
  readonly digits: string;
  readonly name: string;
  readonly before?: string;
  readonly say: Say;
}

/** The layouts of a request and its reply, each behind the link that opens it. */
function bothWays({ request, response, texts, digits, name, before, say }: BothWays) {
  const { text } = say;
  const same = request === response && request.fields.length > 0;
  const reply = { texts, kind: 'reply' } as const;
  const silent = problemsOf(reply).some(({ code }) => code === 'sub-function-without-reply');
  return (
    <dl class="ways">
      <dt>{frameLink({ texts }, text.request, text.of(text.request, digits, name))}</dt>
      <dd>{layoutCell(request, say, before)}</dd>
      <dt>{silent ? text.reply : frameLink(reply, text.reply, text.of(text.reply, digits, name))}</dt>
      <dd>
        {silent ? <i>{text.neverAnswered}</i> : same ? <i>{text.sameAsRequest}</i> : layoutCell(response, say, before)}
      </dd>
    </dl>
  );
}

export function subFunctionEntries(say: Say): readonly Entry[] {
  const { text } = say;
  const { code: functionCode, request, response, section } = functionOf(0x08);
  return diagnosticSubFunctions.map((sub) => {
    const { code, name } = sub;
    const texts = { functionCode, subFunction: code };
    const hex = digits(code, 2);
    return {
      key: String(code),
      codes: [code],
      cells: [
        codeCell(hex, code),
        <>
          {frameLink({ texts }, name)}
          {'reserved' in sub && <small class="badge">{text.reserved}</small>}
        </>,
        bothWays({
          request: layoutAfter(request, code),
          response: layoutAfter(response, code),
          texts,
          digits: hex,
          name,
          say,
        }),
        sectionCell(say, sectionOfProblem({ texts }, 'subFunction') ?? section),
      ],
    };
  });
}

export function meiEntries(say: Say): readonly Entry[] {
  const { code: functionCode } = functionOf(0x2b);
  return meiTypes.map(({ meiType, name, section, request, response }) => {
    const texts = { functionCode, meiType };
    const hex = digits(meiType);
    return {
      key: String(meiType),
      codes: [meiType],
      also: `${digits(functionCode)}/${hex} ${functionCode}/${meiType}`,
      cells: [
        codeCell(hex, meiType),
        frameLink({ texts }, name),
        bothWays({ request, response, texts, digits: hex, name, say }),
        sectionCell(say, section),
      ],
    };
  });
}
