// The script of the one file. The page and all its workers run it, each worker under a name that says which it is.
const workers = {
  digest: () => import('../../src/ui/parts/workers/digest-worker.ts'),
  maps: () => import('../../src/ui/parts/workers/maps-worker.ts'),
  session: () => import('../../src/ui/parts/workers/session-worker.ts'),
  trace: () => import('../../src/ui/parts/workers/trace-worker.ts'),
};

if (typeof document === 'undefined') workers[globalThis.name.split('-')[1]]();
else import('../../src/ui/main.tsx');
