import fc from 'fast-check';

// While mutants are tried, each property is asked of a few examples: mutants are many, and what breaks a property breaks most of them.
fc.configureGlobal({ numRuns: 10 });
