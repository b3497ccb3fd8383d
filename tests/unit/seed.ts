import fc from 'fast-check';

// Properties are asked of the same examples each time, so that what passed passes again. Another seed asks them of others.
fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: Number(process.env['FRAMEWRIGHT_SEED'] ?? 1) });
