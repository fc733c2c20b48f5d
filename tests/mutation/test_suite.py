"""The tests of a build: what each runs, how long it takes, and whether it fails with a fault."""

import json
import os
import re
import signal
import subprocess
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from mutate import limit_memory
from shared_build import BuildError

MIN_LIMIT = 20  # seconds
LIMIT_FACTOR = 4  # times the usual time
TIMES = {False: "drawn_faults.json", True: "drawn_faults_brief.json"}  # by whether the tests are brief
NEVER = {"package", "fuzz", "structure"}  # labels
BY_HAND = re.compile(r"mutation_|drawn_faults|tidy")


@dataclass
class Test:
    name: str
    command: list
    folder: str
    environment: dict
    labels: set
    fails_with: str
    skips_with: int
    program: str = None  # its own program, if it is one
    loaded: set = field(default_factory=set)  # libraries of the build, also of the programs that it runs


def properties_of(entry):
    return {item["name"]: item["value"] for item in entry["properties"]}


class TestSuite:
    """Runs tests as ctest would, each in folders of its own. Brief tests repeat as in `./platon test --all`."""

    def __init__(self, build, root, brief=False):
        self._build = build
        self._root = root
        self._brief = brief
        self._sources = {path.stem: path for path in (root / "tests").rglob("*_test.cpp")}
        self.tests = [test for test in self._read() if test.loaded]
        self._times_lock = threading.Lock()
        self._times = {}

    def source_of(self, test):
        """The test file relative to the tree, or None."""
        path = self._sources.get(test.name)
        return path.relative_to(self._root).as_posix() if path else None

    def _read(self):
        command = ["ctest", "--show-only=json-v1"]
        result = subprocess.run(command, cwd=self._build.directory, capture_output=True, text=True)
        if result.returncode != 0:
            raise BuildError(result.stderr)
        for entry in json.loads(result.stdout)["tests"]:
            values = properties_of(entry)
            labels = set(values.get("LABELS", ()))
            if "command" not in entry or labels & NEVER or BY_HAND.match(entry["name"]):
                continue
            test = Test(
                entry["name"],
                entry["command"],
                values.get("WORKING_DIRECTORY", str(self._build.directory)),
                dict(item.split("=", 1) for item in values.get("ENVIRONMENT", ())),
                labels,
                "|".join(values.get("FAIL_REGULAR_EXPRESSION", ())),
                values.get("SKIP_RETURN_CODE", 0),
            )
            self._find_programs(test)
            yield test

    def _find_programs(self, test):
        """What a test runs is its command and the programs that its file names."""
        named = [self._build.relative(word) for word in test.command if os.path.isabs(word)]
        programs = [name for name in named if name]
        test.program = programs[0] if programs and os.path.basename(test.command[0]) == test.name else None
        texts = [path for path in map(Path, test.command) if path.suffix == ".py" and path.is_file()]
        texts = [path for text in texts for path in text.parent.glob("*.py")]
        if test.name in self._sources:
            texts.append(self._sources[test.name])
            for name in re.findall(r'#include "(tests/[^"]+)"', self._sources[test.name].read_text(encoding="utf-8")):
                texts += [path for path in (self._root / name, (self._root / name).with_suffix(".cpp")) if path.is_file()]
        for text in texts:
            for name in set(re.findall(r"\bplaton-[a-z]+(?:-[a-z]+)?\b", text.read_text(encoding="utf-8"))):
                programs += [path for path in (f"bin/{name}", f"tests/bin/{name}") if path in self._build.programs]
        for program in programs:
            test.loaded |= self._build.libraries_of(program)

    def failure(self, test, overlay=None, program=None, limit=None):
        """How the test fails, or None. `overlay` has the changed libraries; `program` takes the place of its own."""
        command = [str(program) if program and word == test.command[0] else word for word in test.command]
        with tempfile.TemporaryDirectory(prefix="f") as place:
            environment = self._environment(test, overlay, Path(place))
            return self._judged(test, command, environment, Path(place), limit or self._limit(test))

    def _environment(self, test, overlay, place):
        """Its temporary files have a short path, since those of sockets must be short."""
        environment = {name: value for name, value in os.environ.items() if name not in ("PLATON_BRIEF", "PLATON_LONG")}
        if self._brief:
            environment["PLATON_BRIEF"] = "1"
        home = test.environment.get("HOME")
        for name, value in test.environment.items():
            environment[name] = value.replace(home, str(place / "h"), 1) if home and value.startswith(home) else value
        for folder in (place / "h/run", place / "t"):
            folder.mkdir(parents=True)
        environment.update(TMPDIR=str(place / "t"), GTEST_FAIL_FAST="1", GTEST_BRIEF="1")
        if overlay:
            environment["LD_LIBRARY_PATH"] = str(overlay)
        return environment

    def _judged(self, test, command, environment, place, limit):
        log = place / "log"
        with log.open("wb") as output:
            process = subprocess.Popen(
                command,
                cwd=test.folder,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
                preexec_fn=limit_memory,
            )
        try:
            process.wait(limit)
        except subprocess.TimeoutExpired:
            return f"runs longer than {limit:.0f} s"
        finally:
            end_group(process)
        text = log.read_text(encoding="utf-8", errors="replace")
        if process.returncode < 0:
            return f"is killed by signal {-process.returncode}"
        if process.returncode not in (0, test.skips_with):
            return "fails: " + (first_failure(text) or f"exit code {process.returncode}")
        return "runs no test" if test.fails_with and re.search(test.fails_with, text) else None

    def _limit(self, test):
        return max(MIN_LIMIT, LIMIT_FACTOR * self.seconds(test))

    def seconds(self, test):
        return self._times[test.name]["seconds"]

    def is_sound(self, test):
        """Whether it passes without a fault."""
        return self._times[test.name]["passes"]

    def failure_without_fault(self, test):
        return self._times[test.name]["failure"]

    def measure(self, tests, jobs, longest):
        """Runs the tests without a fault, except those whose result is known from an earlier call. Returns those that
        fail, or run longer than `longest` seconds."""
        known = self._known()
        stale = [test for test in tests if known.get(test.name, {}).get("stamp") != self._stamp(test)]
        self._times = known
        with ThreadPoolExecutor(jobs) as pool:
            list(pool.map(lambda test: self._measure(test, longest), stale))
        return [test for test in tests if not self.is_sound(test)]

    def _times_file(self):
        return self._build.directory / TIMES[self._brief]

    def _known(self):
        path = self._times_file()
        return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}

    def _measure(self, test, longest):
        failure = None
        for _ in range(2):  # one that passes only sometimes is left out
            start = time.monotonic()
            failure = self.failure(test, limit=1.5 * longest)
            seconds = time.monotonic() - start
            if failure or seconds > 5:
                break
        with self._times_lock:
            self._times[test.name] = {
                "stamp": self._stamp(test), "seconds": round(seconds, 2), "passes": failure is None, "failure": failure,
            }  # fmt: skip
            self._times_file().write_text(json.dumps(self._times, indent=1), encoding="utf-8")

    def _stamp(self, test):
        files = [*test.loaded, *([test.program] if test.program else [])]
        return self._build.time_of(files)


def end_group(process):
    """Ends the process and those that it has started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def first_failure(output):
    """The first test that GoogleTest or unittest says to have failed."""
    match = re.search(r"^\[  FAILED  \] ([\w/.]+)", output, re.MULTILINE) or re.search(
        r"^(?:FAIL|ERROR): (\w+)", output, re.MULTILINE
    )
    return match[1] if match else None
