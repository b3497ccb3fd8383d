import { copyFileSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import { programsOf, type Runner, testExchanges, testPrograms } from './compiled.ts';
import { cache, emptyFolder, run, runTool, strictTool, withTools } from './tools.ts';

const written = programsOf('go');

withTools(['go'], () => {
  const folder = emptyFolder('go');
  const plain = emptyFolder('gofmt');
  const env = { GOTOOLCHAIN: 'local', GOFLAGS: '-mod=mod' };
  let runner: Runner;
  let sources: readonly string[];

  beforeAll(async () => {
    for (const file of ['go.mod', 'go.sum']) copyFileSync(join(cache, 'go', file), join(folder, file));
    for (const { id, file } of written) {
      mkdirSync(join(folder, id));
      const own = file.text.replace('package main', `package ${id}`);
      writeFileSync(
        join(folder, id, file.name),
        `${own}\nfunc Run(arguments []string) int { return run(arguments) }\n`,
      );
      writeFileSync(join(plain, `${id}.go`), file.text);
    }
    writeFileSync(join(folder, 'main.go'), mainOf(written.map(({ id }) => id)));
    sources = readdirSync(folder).map((name) => join(folder, name));
    const output = join(folder, 'programs');
    const built = await runTool('go', ['build', '-o', output, '.'], { cwd: folder, env, sources, output });
    expect(built.err).toBe('');
    runner = (input) => run(join(folder, 'programs'), [], { input });
  });

  test('gofmt would change nothing', async () => {
    expect((await runTool('gofmt', ['-d', plain], { sources: [plain] })).out).toBe('');
  });

  test('go vet finds nothing', async () => {
    const [go, ...strict] = strictTool('go');
    expect((await runTool(go, [...strict, './...'], { cwd: folder, env, sources })).err).toBe('');
  });

  testPrograms(written, async () => runner, { target: 'go', command: 'go vet' });
  testExchanges(written, async () => runner);
});

const mainOf = (ids: readonly string[]): string => `package main

import (
	"bufio"
	"fmt"
	"os"
	"strings"

${ids.map((id) => `\t"programs/${id}"`).join('\n')}
)

var programs = map[string]func([]string) int{
${ids.map((id) => `\t"${id}": ${id}.Run,`).join('\n')}
}

func main() {
	lines := bufio.NewScanner(os.Stdin)
	lines.Buffer(nil, 1<<20)
	for lines.Scan() {
		words := strings.Split(lines.Text(), "\\t")
		code := programs[words[0]](words[1:])
		fmt.Printf("\\x03%d\\x04", code)
	}
}
`;
