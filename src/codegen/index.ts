export { type GuideFault, guideFaults, guideListing } from './examples/guide-listing.ts';
export { type TargetGroup, type TargetOffer, targetOffer } from './offers.ts';
export { type CrcWay, crcWays, type ProgramOptions, type ProgramPart, programParts } from './options.ts';
export type { ProgramNote } from './plan.ts';
export { type Program, type ProgramSubject, programTargets, writeProgram } from './program.ts';
export { type TargetProof, targetProof } from './proofs.ts';
export { usualProgram } from './settings.ts';
