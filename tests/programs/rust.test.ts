import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect } from 'vitest';
import { programsOf, type Runner, testExchanges, testPrograms } from './compiled.ts';
import { cache, emptyFolder, run, runTool, strictTool, withTools } from './tools.ts';

const OUTSIDE = `
/// Called by the test; the main function is used, too.
pub fn outside(arguments: &[String]) -> i32 {
    if arguments.is_empty() {
        main();
    }
    match run(arguments) {
        Ok(true) => 0,
        Ok(false) => 1,
        Err(error) => {
            eprintln!("{error}");
            1
        }
    }
}
`;

const written = programsOf('rust');

withTools(['cargo'], () => {
  const folder = emptyFolder('rust');
  const packages = join(cache, 'rust/target/debug/deps');
  let runner: Runner;

  beforeAll(async () => {
    for (const { id, file } of written) writeFileSync(join(folder, `${id}.rs`), file.text + OUTSIDE);
    writeFileSync(join(folder, 'main.rs'), mainOf(written.map(({ id }) => id)));
    const library = readdirSync(packages).find((name) => /^libserialport-.*\.rlib$/.test(name)) ?? '';
    const [rustc, ...strict] = strictTool('rust');
    const args = [
      ...strict,
      ...['--edition', '2021', '-C', 'debuginfo=0', '-L', `dependency=${packages}`],
      ...['--extern', `serialport=${join(packages, library)}`, '-o', join(folder, 'programs'), join(folder, 'main.rs')],
    ];
    expect((await runTool(rustc, args, { sources: [folder], output: join(folder, 'programs') })).err).toBe('');
    runner = (input) => run(join(folder, 'programs'), [], { input });
  });

  testPrograms(written, async () => runner, { target: 'rust', command: 'rustc -D warnings' });
  testExchanges(written, async () => runner);
});

const mainOf = (ids: readonly string[]): string => `${ids.map((id) => `mod ${id};`).join('\n')}

fn main() {
    for line in std::io::stdin().lines().map_while(Result::ok) {
        let words: Vec<String> = line.split('\\t').map(String::from).collect();
        let code = match words[0].as_str() {
${ids.map((id) => `            "${id}" => ${id}::outside(&words[1..]),`).join('\n')}
            _ => 99,
        };
        print!("\\u{3}{code}\\u{4}");
    }
}
`;
