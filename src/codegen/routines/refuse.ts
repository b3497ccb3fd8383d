import { binary, type Expression, type Operator, type Statement } from '../code.ts';
import { type FaultName, fault } from '../faults.ts';
import { giveBack, type Remarks, when } from './terms.ts';

/** Ends a check with a fault. */
export const fail = (of: FaultName): readonly Statement[] => [giveBack(fault(of))];

/** Ends a check with a fault if a comparison holds. */
export const refuse = (
  left: Expression,
  operator: Operator,
  right: Expression,
  of: FaultName,
  remarks: Remarks = {},
): Statement => when(binary(left, operator, right), fail(of), [], remarks);
