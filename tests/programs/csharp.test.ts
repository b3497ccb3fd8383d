import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect } from 'vitest';
import { programsOf, type Runner, testExchanges, testPrograms } from './compiled.ts';
import { emptyFolder, run, runTool, strictTool, withTools } from './tools.ts';

const written = programsOf('csharp');

withTools(['mcs', 'mono', 'gcc'], () => {
  const folder = emptyFolder('csharp');
  let runner: Runner;

  beforeAll(async () => {
    const files = written.map(({ id, file }) => {
      const path = join(folder, `${id}.cs`);
      writeFileSync(path, `namespace ${id}\n{\n${file.text}}\n`);
      return path;
    });
    const main = join(folder, 'Programs.cs');
    writeFileSync(main, MAIN);
    const program = join(folder, 'programs.exe');
    const [mcs, ...strict] = strictTool('csharp');
    const args = [...strict, '-r:System.dll', '-main:Programs', `-out:${program}`, main, ...files];
    const compiled = await runTool(mcs, args, { sources: [main, ...files], output: program });
    expect(compiled.out + compiled.err).toBe('');
    const modem = join(folder, 'modem.so');
    const source = join(import.meta.dirname, 'native/modem.c');
    const flags = ['-shared', '-fPIC', '-O2', '-Wall', '-Wextra', '-Werror'];
    expect((await runTool('gcc', [...flags, '-o', modem, source], { sources: [source], output: modem })).err).toBe('');
    runner = (input) => run('mono', [program], { input, env: { LD_PRELOAD: modem } });
  });

  testPrograms(written, async () => runner, { target: 'csharp', command: 'mcs -warnaserror' });
  testExchanges(written, async () => runner);
});

const MAIN = `
using System;
using System.Linq;
using System.Reflection;

static class Programs
{
    static void Main()
    {
        Type[] types = Assembly.GetExecutingAssembly().GetTypes();
        for (string line = Console.ReadLine(); line != null; line = Console.ReadLine())
        {
            string[] words = line.Split('\\t');
            MethodInfo main = types.First(type => type.Namespace == words[0] && type.IsAbstract)
                .GetMethod("Main", BindingFlags.NonPublic | BindingFlags.Static);
            object code = main.Invoke(null, new object[] { words.Skip(1).ToArray() });
            Console.Write("\\u0003" + code + "\\u0004");
        }
    }
}
`;
