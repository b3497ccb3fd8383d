import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect } from 'vitest';
import { programsOf, type Runner, testExchanges, testPrograms } from './compiled.ts';
import { cache, emptyFolder, run, runTool, strictTool, withTools } from './tools.ts';

const written = programsOf('java');

withTools(['javac', 'java'], () => {
  const folder = emptyFolder('java');
  const jar = join(cache, 'java/jSerialComm-2.11.4.jar');
  let runner: Runner;

  beforeAll(async () => {
    const files = written.map(({ id, file }) => {
      mkdirSync(join(folder, id));
      const path = join(folder, id, file.name);
      writeFileSync(path, file.text.replace(/^import /m, `package ${id};\n\nimport `));
      return path;
    });
    const main = join(folder, 'Programs.java');
    writeFileSync(main, MAIN);
    const out = join(folder, 'out');
    const [javac, ...strict] = strictTool('java');
    const args = ['-encoding', 'UTF-8', ...strict, '-cp', jar, '-d', out, main, ...files];
    expect((await runTool(javac, args, { sources: [main, ...files], output: out })).err).toBe('');
    const classes = Object.fromEntries(written.map(({ id, file }) => [id, `${id}.${file.name.replace('.java', '')}`]));
    const named = (input: string) => input.replace(/^\w+/gm, (id) => classes[id] ?? id);
    const options = ['-XX:TieredStopAtLevel=1', '-XX:+UseSerialGC', '-Xshare:auto'];
    runner = (input) => run('java', [...options, '-cp', `${jar}:${out}`, 'Programs'], { input: named(input) });
  });

  testPrograms(written, async () => runner, { target: 'java', command: 'javac -Xlint:all -Werror' });
  testExchanges(written, async () => runner);
});

const MAIN = `
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.lang.reflect.Method;
import java.util.Arrays;

public final class Programs {
    public static void main(String[] arguments) throws Exception {
        BufferedReader lines = new BufferedReader(new InputStreamReader(System.in));
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            String[] words = line.split("\\t", -1);
            Method run = Class.forName(words[0]).getDeclaredMethod("run", String[].class);
            run.setAccessible(true);
            Object code = run.invoke(null, (Object) Arrays.copyOfRange(words, 1, words.length));
            System.out.print("\\3" + code + "\\4");
        }
    }
}
`;
