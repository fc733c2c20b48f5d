#!/usr/bin/env python3
"""Measures the processor time of `./platon test --all`: of each lane, of the targets built and of the tests.

usage: suite.py ROOT [--write]. Builds each lane from nothing in build/suite, which takes as long as the suite itself.
Prints the tables of CONTRIBUTING.md; --write writes them there. Exit 1 if a build or a test fails.
"""

import json
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "net/matrix"))

from page import replace_part, with_part  # noqa: E402
from processes import Failure, exit_code_of  # noqa: E402

COMMAND = "tests"
PAGE = "CONTRIBUTING.md"
ROWS = 12  # of the costliest targets and tests
LANE = re.compile(r"^ +run_lane (\S+) (\S+) (all|outside|threads)$", re.MULTILINE)


@dataclass
class Lane:
    """A lane of `./platon test --all`, and the processor seconds of what it builds and runs."""

    name: str
    preset: str
    label: str
    built: Counter = field(default_factory=Counter)
    run: Counter = field(default_factory=Counter)


def lanes_of(script):
    """The lanes of --all, as tests/test_command.sh names them."""
    return [Lane(*found) for found in LANE.findall(script)]


def checked(command, root, **options):
    result = subprocess.run(list(map(str, command)), cwd=root, capture_output=True, text=True, **options)
    if result.returncode != 0:
        end = "\n".join((result.stdout + result.stderr).splitlines()[-30:])
        raise Failure(f"{' '.join(map(str, command))} fails:\n{end}")
    return result.stdout


def target_of(output):
    """client/CMakeFiles/platon_client_gl.dir/… and tests/bin/x as platon_client_gl and x."""
    found = re.search(r"CMakeFiles/([^/]+)\.dir/", output)
    return found[1] if found else Path(output).name


def build(lane, root, folder):
    shutil.rmtree(folder, ignore_errors=True)
    log = folder.with_suffix(".log")
    log.unlink(missing_ok=True)
    meter = Path(__file__).resolve().parent / "meter.py"
    checked(["cmake", "--preset", lane.preset, "-B", folder, "-DBUILD_TESTING=ON", f"-DCMAKE_CXX_COMPILER_LAUNCHER={meter}",
             f"-DCMAKE_CXX_LINKER_LAUNCHER={meter}"], root)  # fmt: skip
    checked(["cmake", "--build", folder, "--target", f"{lane.label}_tests"], root, env=os.environ | {"PLATON_METER": str(log), "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"})
    for line in log.read_text(encoding="utf-8").splitlines():
        seconds, output = line.split(" ", 1)
        lane.built[target_of(output)] += float(seconds)


def tests_of(lane, root, folder):
    """[(name, command, environment, working directory, what its output must contain)] of the tests of the lane."""
    described = json.loads(checked(["ctest", "--test-dir", folder, "--show-only=json-v1"], root))
    for test in described["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        if lane.label in properties.get("LABELS", []):
            environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
            expected = properties.get("PASS_REGULAR_EXPRESSION", [])
            yield test["name"], test["command"], environment, properties.get("WORKING_DIRECTORY", folder), expected


def measure(lane, tests):
    """Runs the tests, one for each processor at a time."""
    left = queue.SimpleQueue()
    for test in tests:
        left.put(test)
    failed = []

    def work():
        while True:
            try:
                name, command, environment, directory, expected = left.get_nowait()
            except queue.Empty:
                return
            environment = os.environ | environment | {"PLATON_BRIEF": "1"}
            with tempfile.TemporaryFile("w+", errors="replace") as output:
                child = subprocess.Popen(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                                         stdout=output, stderr=output)  # fmt: skip
                _, status, used = os.wait4(child.pid, 0)
                output.seek(0)
                said = output.read()
            lane.run[name] = used.ru_utime + used.ru_stime
            code = os.waitstatus_to_exitcode(status)
            passes = any(re.search(words, said) for words in expected) if expected else code in (0, 77)  # 77: skipped
            if not passes:
                failed.append(name)

    threads = [threading.Thread(target=work) for _ in range(os.cpu_count())]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if failed:
        raise Failure(f"lane {lane.name}: these tests fail: {', '.join(sorted(failed))}")


def rows(heads, cells):
    return "\n".join(f"| {' | '.join(map(str, row))} |" for row in (heads, ["---"] * len(heads), *cells))


def tables(lanes):
    """The generated part of the page."""
    product = [sum(seconds for target, seconds in lane.built.items() if is_product(target)) for lane in lanes]
    built = [lane.built.total() for lane in lanes]
    parts = [rows(["lane", "product built, s", "tests built, s", "tests run, s", "tests"],
                  [[lane.name, round(ours), round(all_built - ours), round(lane.run.total()), len(lane.run)]
                   for lane, ours, all_built in zip(lanes, product, built, strict=True)])]  # fmt: skip
    for what, of in (("target", "built"), ("test", "run")):
        costs = {(lane.name, name): seconds for lane in lanes for name, seconds in getattr(lane, of).items()}
        costliest = sorted(costs, key=costs.get, reverse=True)[:ROWS]
        parts.append(rows([what, "lane", "s"], [[f"`{name}`", lane, f"{costs[lane, name]:.1f}"] for lane, name in costliest]))
    return "\n\n".join(parts)


def is_product(target):
    if target.endswith("_testing"):
        return False
    return target.startswith(("platon_client", "platon_server", "platon_levels", "platon_protocol", "platon-")) or target in (
        "platon_headers", "platon_exact", "platon_physics", "platon_game", "platon_sim")  # fmt: skip


def run(root, writes):
    page = root / PAGE
    with_part(page.read_text(encoding="utf-8"), "", COMMAND)  # fails before the run, not after it
    lanes = lanes_of((root / "tests/test_command.sh").read_text(encoding="utf-8"))
    if not lanes:
        raise Failure("tests/test_command.sh: no line 'run_lane NAME PRESET LABEL' in run_lanes")
    for lane in lanes:
        folder = root / "build/suite" / lane.preset
        folder.parent.mkdir(parents=True, exist_ok=True)
        build(lane, root, folder)
        measure(lane, list(tests_of(lane, root, folder)))
    part = tables(lanes)
    print(part)
    if writes:
        replace_part(page, part, COMMAND)
    return []


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--write"]):
        print(__doc__, file=sys.stderr)
        return 2
    return exit_code_of(lambda: run(Path(arguments[0]).resolve(), arguments[1:] == ["--write"]))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
