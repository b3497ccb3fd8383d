import { diagnosticSubFunctions, type FunctionCode, functionCodes, type Layout, meiTypes } from '../../modbus/index.ts';
import type { ReferenceWords } from '../../words/index.ts';
import { layoutAfter, problemsOf, type ReferenceFrame, sectionOfProblem } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';
import { codeCell, type Entry, frameLink, type Section, sectionCell } from './entry.tsx';
import { digits, layoutCell } from './layout.tsx';

type Texts = ReferenceFrame['texts'];

/** Every public function code. */
export function functionSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  return {
    subject: 'functions',
    columns: [c.code, c.function, c.table, c.broadcast, c.bytes, c.section],
    entries: functionCodes.map((description) => functionEntry(description, text)),
  };
}

function functionEntry(description: FunctionCode, text: ReferenceWords): Entry {
  const { code, name, section, table, broadcast, serialOnly, request, response } = description;
  const texts = { functionCode: code };
  const hex = digits(code);
  return {
    key: String(code),
    codes: [code],
    also: `fc ${words.page.groups[description.group]}`,
    cells: [
      codeCell(hex, code),
      <>
        {frameLink({ texts }, name)}
        {serialOnly && <small class="badge">{text.serialOnly}</small>}
      </>,
      table ? words.tables[table].many : <span class="soft">{text.noTable}</span>,
      broadcast ? <b>{text.yes}</b> : <span class="soft">{text.no}</span>,
      bothWays({ request, response, texts, digits: hex, name, before: hex, text }),
      sectionCell(section),
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
  readonly text: ReferenceWords;
}

/** The layouts of a request and its reply, each behind the link that opens it. */
function bothWays({ request, response, texts, digits, name, before, text }: BothWays) {
  const same = request === response && request.fields.length > 0;
  const reply = { texts, kind: 'reply' } as const;
  const silent = problemsOf(reply).some(({ code }) => code === 'sub-function-without-reply');
  return (
    <dl class="ways">
      <dt>{frameLink({ texts }, text.request, text.of(text.request, digits, name))}</dt>
      <dd>{layoutCell(request, text, before)}</dd>
      <dt>{silent ? text.reply : frameLink(reply, text.reply, text.of(text.reply, digits, name))}</dt>
      <dd>
        {silent ? <i>{text.neverAnswered}</i> : same ? <i>{text.sameAsRequest}</i> : layoutCell(response, text, before)}
      </dd>
    </dl>
  );
}

function functionByCode(code: number): FunctionCode {
  const found = functionCodes.find((description) => description.code === code);
  if (found === undefined) throw new Error(`no function ${code}`);
  return found;
}

export function subFunctionSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  const { code: functionCode, request, response, section } = functionByCode(0x08);
  return {
    subject: 'subFunctions',
    columns: [c.code, c.name, c.bytes, c.section],
    entries: diagnosticSubFunctions.map((sub) => {
      const { code, name } = sub;
      const texts = { functionCode, subFunction: code };
      const hex = digits(code, 2);
      return {
        key: String(code),
        codes: [code],
        also: 'sub-function diagnostics',
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
            text,
          }),
          sectionCell(sectionOfProblem({ texts }, 'subFunction') ?? section),
        ],
      };
    }),
  };
}

export function meiSection(text: ReferenceWords): Section {
  const { columns: c } = text;
  const { code: functionCode } = functionByCode(0x2b);
  return {
    subject: 'meiTypes',
    columns: [c.code, c.name, c.bytes, c.section],
    entries: meiTypes.map(({ meiType, name, section, request, response }) => {
      const texts = { functionCode, meiType };
      const hex = digits(meiType);
      return {
        key: String(meiType),
        codes: [meiType],
        also: `mei ${digits(functionCode)}/${hex} ${functionCode}/${meiType}`,
        cells: [
          codeCell(hex, meiType),
          frameLink({ texts }, name),
          bothWays({ request, response, texts, digits: hex, name, text }),
          sectionCell(section),
        ],
      };
    }),
  };
}
