import type { Name } from '../code.ts';
import type { BuildArgument, Plan, PlannedRequest, PlannedStep } from '../plan.ts';
import { Lines } from '../written.ts';
import { exchangeParts, partLines, VERDICT, WAIT_UNTIL } from './powershell-shell.ts';
import { powershellRules, powershellSyntax, powershellText } from './powershell-syntax.ts';
import { ScriptWriter, scriptTarget } from './scripted.ts';
import { argumentTexts, isAnswered, pauseOf, programAbout, programName, SILENCE } from './shell.ts';

const STEP = '    ';
const END = 'if ($good) { exit 0 } else { exit 1 }';

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** What the file of a plan is called. */
const fileName = (plan: Plan): string => `${programName(plan).split(' ').map(capital).join('')}.ps1`;

/** Writes the program of one plan. */
class Writer extends ScriptWriter {
  constructor(plan: Plan) {
    super(
      {
        rules: powershellRules,
        syntax: powershellSyntax,
        lines: () => new Lines(STEP),
        fileName,
        partLines,
        verdict: VERDICT,
        exchangeParts,
        waitUntil: WAIT_UNTIL,
      },
      plan,
    );
  }

  #usage(): readonly string[] {
    const isWhole = this.plan.sequence !== undefined;
    const name = `.\\${fileName(this.plan)}`;
    return [
      ...(this.exchanges ? [`${name} [-${this.isTcp ? 'Server HOST' : 'Port PORT'}]  carries it out`] : []),
      ...(isWhole ? [] : [`${name} -Bytes  prints what is sent`]),
      ...(isWhole || !this.checks ? [] : [`${name} -Check 'HEX HEX …'  checks a reply`]),
    ];
  }

  #define(head: string, about: string, body: () => void): void {
    this.printer.remark(this.lines.part(), about);
    this.lines.add(`function ${head} {`).inside(body).add('}');
  }

  protected override head(): void {
    const { options, sequence } = this.plan;
    const lines = this.lines;
    this.printer.remark(lines, programAbout(this.plan), ...this.#usage());
    const { host, port: tcpPort } = options.server;
    const where = this.isTcp
      ? `[string] $Server = ${powershellText(host)}`
      : `[string] $Port = ${powershellText(options.line.port)}`;
    const given = [
      ...(this.exchanges ? [where] : []),
      ...(sequence === undefined ? ['[switch] $Bytes'] : []),
      ...(sequence === undefined && this.checks ? ['[string[]] $Check'] : []),
    ];
    lines.add(`param(${given.join(', ')})`).add('');
    lines.add("$ErrorActionPreference = 'Stop'");
    if (!this.exchanges) return;
    const { answered } = this;
    this.printer.aligned(lines, [
      ...(this.isTcp ? [{ text: `$ServerPort = ${tcpPort}` }] : []),
      ...(this.isTcp
        ? []
        : [{ text: `$Pause = ${pauseOf(options)}`, comment: 'milliseconds of silence between two frames' }]),
      ...(this.isTcp || !answered
        ? []
        : [{ text: `$Silence = ${SILENCE}`, comment: 'milliseconds of silence that end a reply of unknown length' }]),
      ...(answered ? [{ text: `$Timeout = ${options.timeout}`, comment: 'milliseconds for the whole reply' }] : []),
    ]);
  }

  #given(argument: BuildArgument): string {
    const { type } = argument.parameter;
    const texts = argumentTexts(
      argument,
      (value) => {
        if (type === 'bool') return value === 0 ? '$false' : '$true';
        const text = this.printer.syntax.number({ kind: 'number', type, value, base: 10 });
        return value < 0 || type === 'dword' ? `(${text})` : text;
      },
      ({ routine, value }) => `(${this.name(routine)} (${value}))`,
    );
    return typeof argument.value === 'number' ? texts.join('') : `@(${texts.join(', ')})`;
  }

  protected override built(constant: string, routine: Name, given: readonly BuildArgument[]): void {
    this.printer.remark(this.lines, given.map(({ parameter }) => parameter.name).join(', '));
    const call = [this.name(routine), ...given.map((one) => this.#given(one))].join(' ');
    this.lines.add(`[byte[]] ${constant} = ${call}`);
  }

  protected override request(request: PlannedRequest): void {
    const { name, about, check, wanted, list } = request;
    const lines = this.lines;
    const frame = this.frame(request);
    const [show, send] = [this.name(`show ${name}`), this.name(`send ${name}`)];
    if (this.checks && check !== undefined) {
      this.#define(`${show}([byte[]] $reply)`, 'Prints what a reply says; gives whether it is good.', () => {
        const type = list?.type === 'bool' ? 'bool' : list?.type === 'byte' ? 'byte' : 'int';
        if (list?.size !== undefined) lines.add(`$values = [${type}[]]::new(${list.size})`);
        lines.add(`$result = ${this.name(check)} ${frame} $reply $reply.Length${list ? ' $values' : ''}`);
        lines.add(`Write-Host ${powershellText(`${about}:`)} (Verdict $result)`);
        this.#values(request);
        lines.add('return $result -eq 0');
      });
    }
    if (!this.exchanges) return;
    if (check !== undefined && wanted !== undefined) {
      this.#define(`${send}($line)`, `${about}. Gives the reply, or nothing if it is not good.`, () => {
        lines.add(`[byte[]] $reply = Exchange $line ${frame} ${powershellText(this.name(wanted))}`);
        lines.add(`if (${show} $reply) { return , $reply }`);
      });
    } else {
      this.#define(`${send}($line)`, `${about}. No reply comes.`, () => {
        lines.add(`Send $line ${frame}`).add('return , [byte[]]::new(0)');
      });
    }
  }

  #values({ values, list }: PlannedRequest): void {
    if (values.length === 0 && list === undefined) return;
    const lines = this.lines;
    lines.add('if ($result -eq 0) {').inside(() => {
      for (const { name, routine, unit } of values) {
        const parts = [
          powershellText(`${name} =`),
          `(${this.name(routine)} $reply)`,
          ...(unit === '' ? [] : [powershellText(unit)]),
        ];
        lines.add(`Write-Host ${parts.join(' ')}`);
      }
      if (list !== undefined) lines.add(`Write-Host ${powershellText(`${list.name}:`)} $values`);
    });
    lines.add('}');
  }

  protected override steps(name: 'steps' | 'finish', about: string, steps: readonly PlannedStep[]): void {
    if (steps.length > 0) this.#define(`${capital(name)}($line)`, about, () => this.#body(steps, name === 'steps', 1));
  }

  #body(steps: readonly PlannedStep[], mayStop: boolean, depth: number): void {
    const lines = this.lines;
    for (const step of steps) {
      this.printer.remark(lines, step.about);
      const fail = `throw ${powershellText(`${step.about}: failed`)}`;
      if (step.kind === 'wait') lines.add(`Start-Sleep -Milliseconds ${step.duration}`);
      if (step.kind === 'send') {
        const call = `${this.name(`send ${step.request.name}`)} $line`;
        const stops = step.stops && mayStop && isAnswered(step.request);
        lines.add(stops ? `if ($null -eq (${call})) { ${fail} }` : `[void] (${call})`);
      }
      if (step.kind === 'repeat') {
        const turn = `$turn${depth}`;
        lines.add(`for (${turn} = 1; ${turn} -le ${step.times}; ${turn}++) {`);
        lines.inside(() => this.#body(step.steps, mayStop, depth + 1)).add('}');
      }
      if (step.kind !== 'until') continue;
      lines.add('$holds = {').inside(() => {
        lines.add(`$reply = ${this.name(`send ${step.request.name}`)} $line`);
        lines.add(`($null -ne $reply) -and (${this.name(step.holds)} $reply)`);
      });
      lines.add('}');
      const call = `WaitUntil $holds ${step.interval} ${step.timeout}`;
      lines.add(step.stops && mayStop ? `if (-not (${call})) { ${fail} }` : `[void] (${call})`);
    }
  }

  protected override main(): void {
    const { requests, sequence, options } = this.plan;
    const lines = this.lines.part();
    const hex = (request: PlannedRequest) => `[BitConverter]::ToString(${this.frame(request)})`;
    if (sequence === undefined) {
      const print = () => {
        for (const request of requests) lines.add(hex(request));
      };
      if (!this.exchanges && !this.checks) {
        print();
        return;
      }
      lines.add('if ($Bytes) {').inside(() => {
        print();
        lines.add('exit 0');
      });
      lines.add('}');
      const checked = requests.filter(({ check }) => check !== undefined);
      if (this.checks) {
        lines.add('if ($Check) {').inside(() => {
          lines.add('$good = $true');
          checked.forEach(({ name }, at) => {
            const pairs = `($Check[${at}] -split '\\W+' | ForEach-Object { [Convert]::ToByte($_, 16) })`;
            lines.add(`if (-not (${this.name(`show ${name}`)} ${pairs})) { $good = $false }`);
          });
          lines.add(END);
        });
        lines.add('}');
      }
      if (!this.exchanges) return;
    }
    const { baud, dataBits, parity, stopBits } = options.line;
    if (this.isTcp) {
      lines.add('$client = [System.Net.Sockets.TcpClient]::new($Server, $ServerPort)');
      lines.add('$line = $client.GetStream()');
    } else {
      const format = `'${capital(parity)}', ${dataBits}, '${stopBits === 1 ? 'One' : 'Two'}'`;
      lines.add(`$line = [System.IO.Ports.SerialPort]::new($Port, ${baud}, ${format})`).add('$line.Open()');
    }
    lines.add('try {').inside(() => {
      if (sequence !== undefined) {
        if (sequence.finally.length === 0) lines.add('Steps $line');
        else lines.add('try { Steps $line } finally { Finish $line }');
        return;
      }
      lines.add('$good = $true');
      for (const { name } of requests)
        lines.add(`if ($null -eq (${this.name(`send ${name}`)} $line)) { $good = $false }`);
    });
    lines
      .add('} finally {')
      .inside(() => lines.add(this.isTcp ? '$client.Close()' : '$line.Close()'))
      .add('}');
    lines.add(sequence === undefined ? END : 'exit 0');
  }
}

export const powershell = scriptTarget(
  { id: 'powershell', name: 'PowerShell (System.IO.Ports)', language: 'powershell', proof: 'rules' },
  Writer,
);
