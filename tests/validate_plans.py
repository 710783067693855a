"""Replays plans with pyperplan: its parser reads the task, its operators carry the plan out.

Arguments, three for each plan: domain, task, a file with one `(operator arguments)` a line. Prints a
line for each plan: `valid N` with its length, or what is wrong.
"""

import logging
import os
import re
import sys
import tempfile

from pyperplan.grounding import _create_operator, _create_type_map, _get_partial_state
from pyperplan.planner import _parse

# pyperplan reads no negation in preconditions. Where a domain only says that two parameters differ,
# that is taken out of its text and checked here.
DIFFERENT = re.compile(r"\(\s*not\s*\(\s*=\s*(\?[^\s()]+)\s+(\?[^\s()]+)\s*\)\s*\)")
ACTION = re.compile(r"\(\s*:action\s+([^\s()]+)", re.IGNORECASE)


def without_inequalities(domain_file):
    """The domain as pyperplan reads it, and the parameters that must differ, by action."""
    with open(domain_file, encoding="utf-8") as file:
        text = file.read().lower()
    different = {}
    names = [(match.start(), match.group(1)) for match in ACTION.finditer(text)]
    for match in DIFFERENT.finditer(text):
        action = [name for start, name in names if start < match.start()][-1]
        different.setdefault(action, []).append(match.groups())
    return DIFFERENT.sub("", text), different


def check(domain_file, task_file, plan_file):
    """What is to be said of one plan."""
    text, different = without_inequalities(domain_file)
    with tempfile.NamedTemporaryFile("w", suffix=".pddl", delete=False) as file:
        file.write(text)
    try:
        problem = _parse(file.name, task_file)
    finally:
        os.unlink(file.name)
    objects = problem.objects
    objects.update(problem.domain.constants)
    objects_of = _create_type_map(objects)
    state = _get_partial_state(problem.initial_state)
    with open(plan_file, encoding="utf-8") as lines:
        steps = [line.split() for line in lines if line.strip()]
    for number, step in enumerate(steps, 1):
        line = " ".join(step)
        if not (line.startswith("(") and line.endswith(")")):
            return f"step {number}: {line} is not (operator arguments)"
        name, *arguments = line[1:-1].split()
        action = problem.domain.actions.get(name)
        if action is None or len(action.signature) != len(arguments):
            return f"step {number}: {line} is no operator"
        assignment = {}
        for (parameter, types), argument in zip(action.signature, arguments):
            if not any(argument in objects_of[kind] for kind in types):
                return f"step {number}: {line}: {argument} is of another type"
            assignment[parameter] = argument
        for one, other in different.get(name, []):
            if assignment[one] == assignment[other]:
                return f"step {number}: {line}: {one} and {other} are the same"
        # Nothing is static here: every precondition is looked up in the state.
        operator = _create_operator(action, assignment, [], state)
        if not operator.applicable(state):
            missing = " ".join(sorted(operator.preconditions - state))
            return f"step {number}: {line} needs {missing}"
        state = operator.apply(state)
    missing = _get_partial_state(problem.goal) - state
    if missing:
        return "the goal lacks " + " ".join(sorted(missing))
    return f"valid {len(steps)}"


if __name__ == "__main__":
    logging.disable(logging.CRITICAL)
    arguments = sys.argv[1:]
    for first in range(0, len(arguments), 3):
        print(check(*arguments[first : first + 3]), flush=True)
