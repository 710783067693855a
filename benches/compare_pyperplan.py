"""Nodes per second: `mo-copp plan` against pyperplan's greedy best-first search with hsa.

    python benches/compare_pyperplan.py [--seconds 30] [--planner target/release/mo-copp] FOLDER [NAME]...

with a Python that has pyperplan 2.1, on the tasks in FOLDER/NAME/{domain,instance-N}.pddl; NAME is
blocks, logistics and driverlog when none is given. Both run on the same task one after the other, so that
a machine that is busy is busy for both.

What is counted, in both: *expansions*, nodes taken from the open list whose successors are made. The time is
that of the search alone, without reading and grounding. pyperplan is what its command runs for `-s gbf -H hsa`:
its own parser, grounding, search and heuristic, as a library; only `task.get_successor_states`, which its
search calls once for each expansion, is wrapped to count, and ends the search when its time is over. A search
that finds a plan in less counts as long as it takes. mo-copp gives its own count and time (`--json`), also when
it is interrupted after the same time. A search that is over within a second is done five times, by both, and
the fastest counts: a millisecond is soon lost to something else on the machine.

*Evaluations* are calls of the heuristic: pyperplan calls it for every successor, mo-copp for those that are new.
"""

import argparse
import json
import logging
import multiprocessing
import re
import statistics
import subprocess
import time
from pathlib import Path


def number_of(task):
    return int(re.sub(r"\D", "", task.stem))


class TimeIsOver(Exception):
    pass


def pyperplan(domain, task, seconds, answer):
    """Expansions, evaluations, seconds of search, and whether there is a plan."""
    from pyperplan.heuristics.relaxation import hSAHeuristic
    from pyperplan.planner import _ground, _parse
    from pyperplan.search import greedy_best_first_search

    logging.disable(logging.CRITICAL)
    ground = _ground(_parse(domain, task))
    heuristic = hSAHeuristic(ground)
    counts = {"expansions": 0, "evaluations": 0}
    successors = ground.get_successor_states

    def counted_successors(state):
        if time.perf_counter() - begin > seconds:
            raise TimeIsOver
        counts["expansions"] += 1
        return successors(state)

    def counted_heuristic(node):
        counts["evaluations"] += 1
        return heuristic(node)

    ground.get_successor_states = counted_successors
    begin = time.perf_counter()
    try:
        found = greedy_best_first_search(ground, counted_heuristic) is not None
    except TimeIsOver:
        found = False
    answer.put((counts["expansions"], counts["evaluations"], time.perf_counter() - begin, found))


def run_pyperplan(domain, task, seconds):
    """The same in a process of its own; none where reading and grounding take too long."""
    answer = multiprocessing.Queue()
    process = multiprocessing.Process(target=pyperplan, args=(domain, task, seconds, answer))
    process.start()
    try:
        return answer.get(timeout=3 * seconds + 60)
    except Exception:  # queue.Empty
        return None
    finally:
        process.kill()
        process.join()


def run_mo_copp(planner, domain, task, seconds):
    """Expansions, states, seconds of search, and whether there is a plan."""
    # Interrupted, it says what it did until then.
    process = subprocess.Popen(
        [planner, "plan", "--json", domain, task], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        text, _ = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.terminate()
        text, _ = process.communicate()
    report = json.loads(text)
    stats = report["stats"]
    return stats["expansions"], stats["states"], stats["search_seconds"], report["plan"] is not None


def fastest(run, *arguments):
    """The run with the least time, of five where they are short."""
    best = run(*arguments)
    for _ in range(4):
        if best is None or best[2] > 1:
            break
        best = min(best, run(*arguments) or best, key=lambda answer: answer[2])
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--planner", default="target/release/mo-copp")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    ratios = []
    print(f"{'task':16} {'pyperplan':>30} {'mo-copp':>36} {'ratio':>8}")
    for name in given.names or ["blocks", "logistics", "driverlog"]:
        domain = str(given.folder / name / "domain.pddl")
        for task in sorted((given.folder / name).glob("instance-*.pddl"), key=number_of):
            label = f"{name} {number_of(task)}"
            theirs = fastest(run_pyperplan, domain, str(task), given.seconds)
            ours = fastest(run_mo_copp, given.planner, domain, str(task), given.seconds)
            if theirs is None or not theirs[0] or not ours[0]:
                print(f"{label:16} nothing expanded", flush=True)
                continue
            their_speed, our_speed = theirs[0] / theirs[2], ours[0] / ours[2]
            ratios.append((our_speed / their_speed, label))
            told = [
                f"{who[0]:9} in {who[2]:8.3f} s{'' if who[3] else ' (no plan)':10}" for who in (theirs, ours)
            ]
            evaluations = (ours[1] / ours[2]) / (theirs[1] / theirs[2])
            print(
                f"{label:16} {told[0]} {their_speed:9.1f}/s   {told[1]} {our_speed:11.1f}/s {ratios[-1][0]:8.1f}"
                f"   evaluations {evaluations:8.1f}",
                flush=True,
            )
    speeds = [ratio for ratio, _ in ratios]
    print(f"least {min(ratios)[0]:.1f} ({min(ratios)[1]}), median {statistics.median(speeds):.1f}, of {len(ratios)} tasks")


if __name__ == "__main__":
    main()
