"""Tries drawn faults on the tests of a build with shared libraries."""

import os
import tempfile
from pathlib import Path

# Objects that are compiled for a changed header before the narrow tests, and before all others.
FEW_OBJECTS = 12
MOST_OBJECTS = 80
REBUILT = 8  # tests outside the folder that are built again for a changed header


class Trial:
    """Tries faults on the tests of a build."""

    def __init__(self, build, suite, tests, narrow_only):
        self._build = build
        self._suite = suite
        self._tests = sorted(tests, key=lambda test: (suite.seconds(test), test.name))
        self._narrow_only = narrow_only

    def result(self, faults):
        """(the first fault that compiles to other code, its result), or None if there is none."""
        for redrawn, fault in enumerate(faults):
            with tempfile.TemporaryDirectory(prefix="o") as directory:
                overlay = Path(directory)
                changed = overlay / fault.file
                changed.parent.mkdir(parents=True)
                changed.write_text(fault.text, encoding="utf-8")
                result = self._tried(fault, overlay)
            if result:
                return fault, {**result, "redrawn": redrawn}
        return None

    def _tried(self, fault, overlay):
        """How it ends, or None if it does not compile or changes no code."""
        narrow = self._narrow(fault.file)
        every = self._build.objects_of(fault.file)
        units = self._nearest(every, fault.file, narrow)
        libraries = self._build.changed_libraries(fault.file, overlay, units)
        if libraries == set() and len(every) <= MOST_OBJECTS:
            units = every
            libraries = self._build.changed_libraries(fault.file, overlay, units)
        if not libraries:
            return None
        caught = self._first(narrow, fault, overlay, libraries, len(narrow))
        if caught:
            return {"stage": "narrow", **caught}
        if self._narrow_only or len(every) > MOST_OBJECTS:
            return {"stage": "narrow", "test": None}
        if len(units) < len(every):
            libraries = self._build.changed_libraries(fault.file, overlay, every)
            if libraries is None:
                return None
        wide = [test for test in self._tests if test not in narrow and test.loaded & libraries]
        caught = self._first(wide, fault, overlay, libraries, REBUILT)
        return {"stage": "wide", **(caught or {"test": None})}

    def _nearest(self, units, file, narrow):
        """The objects to compile before the narrow tests: all, or those of the libraries of these tests nearest to it."""
        if len(units) <= FEW_OBJECTS:
            return units
        loaded = set().union(*(test.loaded for test in narrow))
        own = "/" + os.path.dirname(file.replace("shared/include/platon/", "shared/")).split("/", 1)[-1] + "/"
        libraries = {}
        for unit in units:
            if self._build.library_of(unit) in loaded:
                libraries.setdefault(self._build.library_of(unit), []).append(unit)
        nearest = sorted(libraries.values(), key=lambda found: (not any(own in f"/{unit}" for unit in found), len(found)))
        chosen = []
        for found in nearest:
            if not chosen or len(chosen) + len(found) <= FEW_OBJECTS:
                chosen += found
        return chosen

    def _narrow(self, file):
        """The tests of a file: those with its name first, then those of the folder that mirrors its own."""
        mirrored = "tests/" + os.path.dirname(file).replace("shared/include/platon/", "shared/")
        stem = os.path.basename(file).rsplit(".", 1)[0]
        sources = {test.name: self._suite.source_of(test) for test in self._tests}
        named = [test for test in self._tests if sources[test.name] and self._mirrors(sources[test.name], mirrored, stem)]
        beside = [test for test in self._tests if os.path.dirname(sources[test.name] or "") == mirrored and test not in named]
        return named + beside

    def _mirrors(self, source, mirrored, stem):
        name = os.path.basename(source).removesuffix("_test.cpp")
        if name == stem:
            return source.startswith(mirrored.split("/")[0] + "/" + mirrored.split("/")[1])
        return name.startswith(stem) and os.path.dirname(source) == mirrored

    def _first(self, tests, fault, overlay, libraries, rebuilt):
        """The first of these tests that fails. Those that use a changed header are built again, at most `rebuilt`."""
        for test in tests:
            program = None
            if fault.file.endswith(".h") and test.program and self._build.depends(test.program, fault.file):
                if rebuilt == 0:
                    continue
                rebuilt -= 1
                program = self._build.link_test(test.program, test.name, fault.file, overlay)
                if program is None:
                    continue
            elif not test.loaded & libraries:
                continue
            failure = self._failure(test, overlay, program)
            if failure:
                return {"test": test.name, "how": failure}
        return None

    def _failure(self, test, overlay, program):
        """How the test fails because of the fault: one that fails by chance, or because the machine is busy, does not."""
        failure = self._suite.failure(test, overlay, program)
        if failure and failure.startswith("fails"):
            failure = self._suite.failure(test, overlay, program)
        if failure and failure.startswith("runs longer") and self._suite.failure(test):
            return None
        return failure
