"""Solves LP files with HiGHS: a line for each, `optimal VALUE` or `infeasible`."""

import sys

import highspy

for path in sys.argv[1:]:
    highs = highspy.Highs()
    highs.silent()
    # A warning would mean that the text was not read as it was meant.
    if highs.readModel(path) != highspy.HighsStatus.kOk:
        sys.exit(f"cannot read {path}")
    highs.run()
    status = highs.getModelStatus()
    if status == highspy.HighsModelStatus.kOptimal:
        print("optimal", round(highs.getInfo().objective_function_value))
    elif status in (
        highspy.HighsModelStatus.kInfeasible,
        highspy.HighsModelStatus.kUnboundedOrInfeasible,
    ):
        print("infeasible")
    else:
        sys.exit(f"{path}: {status}")
