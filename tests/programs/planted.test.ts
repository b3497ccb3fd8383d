import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { emptyFolder, run, runTool, strictTool, withTools } from './tools.ts';

/** A file without faults, and the same with something that the tool only warns of, or does not at all if it is not strict. */
interface Planted {
  readonly target: string;
  readonly file: string;
  readonly needs: readonly string[];
  readonly clean: string;
  readonly faulty: string;
  readonly args?: readonly string[];
}

const planted: readonly Planted[] = [
  {
    target: 'c',
    file: 'planted.c',
    needs: ['gcc'],
    args: ['-c'],
    clean: 'int one(void);\nint one(void)\n{\n    return 1;\n}\n',
    faulty: 'int one(void);\nint one(void)\n{\n    int unused;\n    return 1;\n}\n',
  },
  {
    target: 'arduino',
    file: 'planted.cpp',
    needs: ['g++'],
    args: ['-c'],
    clean: 'int one(int) { return 1; }\n',
    faulty: 'int one(int unused) { return 1; }\n',
  },
  {
    target: 'csharp',
    file: 'planted.cs',
    needs: ['mcs'],
    args: ['-t:library'],
    clean: 'public class Planted { public static int One() { return 1; } }\n',
    faulty: 'public class Planted { public static int One() { int unused = 2; return 1; } }\n',
  },
  {
    target: 'java',
    file: 'Planted.java',
    needs: ['javac'],
    clean: 'class Planted { java.util.List<String> list; }\n',
    faulty: 'class Planted { java.util.List list; }\n',
  },
  {
    target: 'go',
    file: 'planted.go',
    needs: ['go'],
    clean: 'package planted\n\nimport "fmt"\n\nfunc One() { fmt.Printf("%d", 1) }\n',
    faulty: 'package planted\n\nimport "fmt"\n\nfunc One() { fmt.Printf("%d", "1") }\n',
  },
  {
    target: 'rust',
    file: 'planted.rs',
    needs: ['cargo'],
    args: ['--crate-type', 'lib'],
    clean: 'pub fn one() -> i32 {\n    1\n}\n',
    faulty: 'pub fn one() -> i32 {\n    let unused = 2;\n    1\n}\n',
  },
  {
    target: 'python',
    file: 'planted.py',
    needs: ['python3', 'python'],
    clean: 'def one() -> int:\n    return 1\n',
    faulty: 'def one():\n    return 1\n',
  },
  {
    target: 'javascript',
    file: 'planted.mjs',
    needs: [],
    clean: 'export const one = 1;\n',
    faulty: 'export const one = ;\n',
  },
];

const folder = emptyFolder('planted');

// The command that stands on the page beside the target.
for (const { target, file, needs, clean, faulty, args = [] } of planted)
  withTools(needs, () => {
    test(`${target}: a warning that is planted fails`, async () => {
      const [program, ...flags] = strictTool(target);
      const all = [...flags, ...args, file];
      const sources = [join(folder, file)];
      writeFileSync(join(folder, file), clean);
      expect(await runTool(program, all, { cwd: folder, sources })).toMatchObject({ code: 0 });
      writeFileSync(join(folder, file), faulty);
      expect((await run(program, all, { cwd: folder })).code).not.toBe(0);
    });
  });
