// Packs the library as npm would, puts it into a small project of its own, and uses it there.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { root, runNpm } from './run.mjs';
import { complaint } from './test-reports.mjs';

/** Bytes, minified and gzipped, that a program gets which decodes frames and does nothing else. */
const budget = 20_000;

const folder = join(root, '.cache', 'package');
const project = join(folder, 'project');
const modules = join(project, 'node_modules');
const { dependencies } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));

/** @typedef {{ what: string, fault: () => string | undefined | Promise<string | undefined> }} Check */

/** Reads the request of AP 6.3: registers 108 to 110. */
const decode = (/** @type {string} */ from) => `import { decodeFrame } from '${from}';
const { outcome, fields } = decodeFrame(Uint8Array.of(0x00, 0x01, 0, 0, 0, 6, 0x11, 0x03, 0x00, 0x6b, 0x00, 0x03), {
  transport: 'tcp',
  direction: 'request',
});
console.log(JSON.stringify({ outcome, fields }));
`;
const decoded = '{"outcome":{"kind":"whole"},"fields":{"startAddress":107,"quantity":3}}';

/** @type {readonly Check[]} */
const checks = [
  { what: 'has what the package is to have, and nothing else', fault: otherFiles },
  { what: 'gives the frames alone to Node without any other package', fault: () => running('framewright/modbus') },
  {
    what: 'runs in Node',
    fault: () => {
      for (const name of Object.keys(dependencies)) {
        mkdirSync(dirname(join(modules, name)), { recursive: true });
        symlinkSync(join(root, 'node_modules', name), join(modules, name), 'junction');
      }
      return running('framewright');
    },
  },
  { what: 'has types for projects of every kind', fault: types },
  { what: `brings at most ${budget / 1000} kB to a page that decodes frames, and no other package`, fault: bundled },
];

/**
 * Checks the package that is made of `dist/lib` as last built.
 * @param {(text: string) => void} tell
 * @returns {Promise<import('./test-reports.mjs').Outcome>}
 */
export async function checkPackage(tell) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(modules, 'framewright'), { recursive: true });
  writeFileSync(join(project, 'package.json'), '{ "type": "module" }\n');
  if ((await runNpm(['pack', '--silent', '--pack-destination', folder], { tell })) !== 0)
    return { passed: 0, failed: 1 };
  const { name, version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  // The path is given by the working directory: tar of Windows takes what stands before a colon for a machine.
  const unpacked = spawnSync('tar', ['-xzf', `../../../${name}-${version}.tgz`, '--strip-components=1'], {
    cwd: join(modules, 'framewright'),
    encoding: 'utf8',
  });
  if (unpacked.status !== 0) throw new Error(`The package does not unpack: ${unpacked.stderr}`);
  /** @type {import('./test-reports.mjs').Complaint[]} */
  const complaints = [];
  for (const { what, fault } of checks) {
    const found = await fault();
    if (found !== undefined) complaints.push(complaint([what], found));
    tell(`  ${found === undefined ? 'ok    ' : 'FAILED'}  ${what}\n${found === undefined ? '' : `${found}\n`}`);
  }
  return { passed: checks.length - complaints.length, failed: complaints.length, complaints };
}

function otherFiles() {
  const { stdout } = spawnSync('tar', ['-tzf', tarball()], { cwd: folder, encoding: 'utf8' });
  const files = stdout
    .trim()
    .split(/\r?\n/)
    .map((file) => file.replace(/^package\//, ''));
  const wrong = files.filter(
    (file) => !/^(dist\/lib\/.+\.(js|d\.ts)|CHANGELOG\.md|LICENSE|README\.md|package\.json)$/.test(file),
  );
  const missing = [
    'LICENSE',
    'README.md',
    'CHANGELOG.md',
    'dist/lib/framewright.js',
    'dist/lib/framewright.d.ts',
  ].filter((file) => !files.includes(file));
  return wrong.length + missing.length === 0
    ? undefined
    : `Not expected: ${wrong.join(', ')}. Missing: ${missing.join(', ')}.`;
}

function tarball() {
  const { name, version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  return `${name}-${version}.tgz`;
}

/** @param {string} from */
function running(from) {
  writeFileSync(join(project, 'decode.js'), decode(from));
  const { stdout, stderr } = spawnSync(process.execPath, ['decode.js'], { cwd: project, encoding: 'utf8' });
  return stdout.trim() === decoded ? undefined : `${stdout}${stderr}`;
}

function types() {
  writeFileSync(
    join(project, 'use.ts'),
    `import { decodeFrame, type Finding, diagnose, encodeFrame, readBytes } from 'framewright';
import { crc16 } from 'framewright/modbus';
const bytes: Uint8Array = encodeFrame({ transport: 'rtu', direction: 'request', unitId: 1, functionCode: 3, fields: { startAddress: 0, quantity: 1 } });
export const findings: readonly Finding[] = diagnose(bytes, { transport: 'rtu' });
export const value: number = crc16(readBytes('01 03').bytes);
// @ts-expect-error: a transport that there is not
decodeFrame(bytes, { transport: 'udp', direction: 'request' });
`,
  );
  const compiler = join(root, 'node_modules', 'typescript', 'bin', 'tsc');
  const kinds = [
    ['node16', 'node16'],
    ['nodenext', 'nodenext'],
    ['esnext', 'bundler'],
  ];
  for (const [module, moduleResolution] of kinds) {
    const compilerOptions = {
      noEmit: true,
      strict: true,
      target: 'es2022',
      lib: ['es2023'],
      types: [],
      module,
      moduleResolution,
    };
    writeFileSync(join(project, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: ['use.ts'] }));
    const { status, stdout, stderr } = spawnSync(process.execPath, [compiler, '-p', '.'], {
      cwd: project,
      encoding: 'utf8',
    });
    if (status !== 0) return `${moduleResolution}: ${stdout}${stderr}`;
  }
  return undefined;
}

async function bundled() {
  writeFileSync(join(project, 'decode.js'), decode('framewright'));
  const result = await build({
    root: project,
    configFile: false,
    logLevel: 'error',
    build: { write: false, target: 'es2022', rolldownOptions: { input: join(project, 'decode.js') } },
  });
  const { output } = /** @type {import('vite').Rolldown.RolldownOutput} */ (result);
  const chunks = output.filter((part) => part.type === 'chunk');
  const size = chunks.reduce((sum, { code }) => sum + gzipSync(code, { level: 9 }).length, 0);
  const others = chunks.flatMap(({ moduleIds }) =>
    moduleIds.filter((id) => Object.keys(dependencies).some((name) => id.includes(`/node_modules/${name}/`))),
  );
  if (others.length > 0) return `It brings ${others.join(', ')}.`;
  return size <= budget ? undefined : `It brings ${size} bytes.`;
}
