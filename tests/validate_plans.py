"""Replays plans with pyperplan: its parser reads the task, its operators carry the plan out.

Two ways to call it, with a Python that has the package pyperplan:

    validate_plans.py DOMAIN TASK PLAN [DOMAIN TASK PLAN]...
        checks plans, each in a file with one `(operator arguments)` a line. Prints a line for each:
        `valid N` with its length, or what is wrong.

    validate_plans.py --planner target/release/mo-copp [--seconds 60] FOLDER [NAME]...
        runs `mo-copp plan` on the tasks in FOLDER/NAME/{domain,instance-N}.pddl (of all NAMEs when
        none is given) and checks what it finds. Ends with 1 when a plan is not valid.
"""

import argparse
import logging
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from pyperplan.grounding import _create_operator, _create_type_map, _get_partial_state
from pyperplan.planner import _parse

# pyperplan reads no negation in preconditions. Where a domain only says that two parameters differ,
# that is taken out of its text and checked here.
DIFFERENT = re.compile(r"\(\s*not\s*\(\s*=\s*(\?[^\s()]+)\s+(\?[^\s()]+)\s*\)\s*\)")
ACTION = re.compile(r"\(\s*:action\s+([^\s()]+)")


def without_inequalities(domain_file):
    """The domain as pyperplan reads it, and the parameters that must differ, by action."""
    text = re.sub(";[^\n]*", "", Path(domain_file).read_text(encoding="utf-8")).lower()
    different = {}
    names = [(match.start(), match.group(1)) for match in ACTION.finditer(text)]
    for match in DIFFERENT.finditer(text):
        action = [name for start, name in names if start < match.start()][-1]
        different.setdefault(action, []).append(match.groups())
    return DIFFERENT.sub("", text), different


def check(domain_file, task_file, steps):
    """What is to be said of one plan, a list of lines."""
    text, different = without_inequalities(domain_file)
    with tempfile.TemporaryDirectory() as folder:
        domain = Path(folder, "domain.pddl")
        domain.write_text(text, encoding="utf-8")
        try:
            problem = _parse(str(domain), str(task_file))
        except Exception as error:  # pyperplan has no one kind of error of its own
            return f"pyperplan cannot read the task: {error}"
    objects = dict(problem.objects)
    objects.update(problem.domain.constants)
    objects_of = _create_type_map(objects)
    state = _get_partial_state(problem.initial_state)
    for number, line in enumerate(steps, 1):
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


def plan(planner, domain, task, seconds):
    """The plan, or none, and what is to be said of it."""
    begin = time.perf_counter()
    try:
        done = subprocess.run([planner, "plan", domain, task], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, f"no answer in {seconds} s"
    took = time.perf_counter() - begin
    said = done.stderr.strip().splitlines()[-1:]
    if done.returncode == 0:
        return done.stdout.split("\n")[:-1], f"{took:.2f} s"
    return None, f"{took:.2f} s, exit code {done.returncode}: {' '.join(said)}"


def number_of(task):
    return int(re.sub(r"\D", "", task.stem))


def run(planner, seconds, folder, names):
    """Plans and checks every task; whether all plans are valid."""
    names = names or sorted(entry.name for entry in folder.iterdir() if (entry / "domain.pddl").is_file())
    tasks = solved = wrong = 0
    for name in names:
        domain = folder / name / "domain.pddl"
        without = []
        count = 0
        for task in sorted((folder / name).glob("instance-*.pddl"), key=number_of):
            count += 1
            steps, said = plan(planner, domain, task, seconds)
            verdict = "no plan" if steps is None else check(domain, task, steps)
            if steps is None:
                without.append(number_of(task))
            elif not verdict.startswith("valid"):
                wrong += 1
            print(f"{name} {number_of(task)}: {verdict}; {said}", flush=True)
        tasks += count
        solved += count - len(without)
        print(f"# {name}: {count - len(without)} of {count} solved; without a plan: {without or 'none'}", flush=True)
    print(f"# all: {solved} of {tasks} solved, {wrong} plans that are not valid")
    return wrong == 0


def main():
    logging.disable(logging.CRITICAL)
    if "--planner" in sys.argv:
        parser = argparse.ArgumentParser()
        parser.add_argument("--planner", required=True)
        parser.add_argument("--seconds", type=float, default=60)
        parser.add_argument("folder", type=Path)
        parser.add_argument("names", nargs="*")
        given = parser.parse_args()
        sys.exit(0 if run(os.path.abspath(given.planner), given.seconds, given.folder, given.names) else 1)
    arguments = sys.argv[1:]
    if not arguments or len(arguments) % 3:
        sys.exit(__doc__)
    for first in range(0, len(arguments), 3):
        domain, task, file = arguments[first : first + 3]
        lines = Path(file).read_text(encoding="utf-8").splitlines()
        print(check(domain, task, [line.strip() for line in lines if line.strip()]), flush=True)


if __name__ == "__main__":
    main()
