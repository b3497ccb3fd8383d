export { findFunctions } from '../../workbench/index.ts';
