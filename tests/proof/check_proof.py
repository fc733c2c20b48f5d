#!/usr/bin/env python3
"""Checks the proof in shared/proof with coq: every file compiles, and no theorem rests on an assumption. Then the functions
that are proved answer queries, and the C++ the same ones: all answers must be equal, but not those of the C++ with a fault.

usage: check_proof.py ROOT QUERIES SEED

QUERIES is the program platon-sweep-queries, which draws a million of them with SEED.
"""

import filecmp
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from bridge_faults import FAULTS

LIBRARY = "Platon"
# What would let something pass for proved.
FORBIDDEN = r"\b(Axiom|Axioms|Parameter|Parameters|Hypothesis|Hypotheses|Variable|Variables|Conjecture|Admitted|admit|Abort|Context)\b"
CLOSED = "Closed under the global context"
PROVED = "platon-proved-sweep"
COUNT = 1000000  # queries

# What platon-sweep-queries is made of, and where its sources include files from.
SOURCES = ("tests/proof/sweep_queries.cpp", "shared/physics/sweep.cpp", "shared/physics/obstacle.cpp", "shared/physics/convex.cpp",
           "shared/physics/region.cpp", "shared/physics/grid.cpp", "shared/physics/ideal_geometry.cpp", "shared/exact/angle.cpp")  # fmt: skip
FOLDERS = ("shared/physics", "shared/exact", "shared/include", "tests/proof", "tests/sim", "tests/shared/physics")


class ProofError(Exception):
    """A sentence about what is wrong."""


def without_comments(text):
    """The text with its comments, which may be nested, as spaces."""
    kept, depth = [], 0
    for part in re.split(r"(\(\*|\*\))", text):
        depth += (part == "(*") - (part == "*)")
        kept.append(re.sub(r"[^\n]", " ", part) if depth or part == "*)" else part)
    return "".join(kept)


def in_order(sources):
    """The names of the files, each after those that it requires."""
    needs = {name: re.findall(r"\w+", " ".join(re.findall(rf"From {LIBRARY} Require Import ([^.]*)\.", text))) for name, text in sources.items()}
    done = []
    while len(done) < len(needs):
        ready = [name for name in sorted(needs) if name not in done and all(need in done for need in needs[name])]
        if not ready:
            raise ProofError(f"shared/proof: {', '.join(sorted(set(needs) - set(done)))}: these files require each other, or one that is missing")
        done += ready
    return done


def coqc(folder, name):
    result = subprocess.run(["coqc", "-R", ".", LIBRARY, f"{name}.v"], cwd=folder, capture_output=True, text=True, check=False)
    if result.returncode:
        raise ProofError(f"shared/proof/{name}.v does not hold:\n{result.stdout}{result.stderr}".rstrip())
    return result.stdout


def check(source, work):
    """Returns the theorems as (file, name). Throws ProofError."""
    sources = {path.stem: without_comments(path.read_text(encoding="utf-8")) for path in source.glob("*.v")}
    for name, text in sources.items():
        for number, line in enumerate(text.splitlines(), 1):
            if found := re.search(FORBIDDEN, line):
                raise ProofError(f"shared/proof/{name}.v:{number}: '{found[0]}' lets something unproved pass: prove it, or make it a premise")
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    order = in_order(sources)
    for name in order:
        shutil.copy(source / f"{name}.v", work)
        coqc(work, name)
    theorems = [(name, theorem) for name in order for theorem in re.findall(r"^Theorem (\w+)", sources[name], re.MULTILINE)]
    asked = [f"From {LIBRARY} Require {' '.join(order)}."] + [f"Print Assumptions {name}.{theorem}." for name, theorem in theorems]
    (work / "assumptions.v").write_text("\n".join(asked) + "\n", encoding="utf-8")
    told = coqc(work, "assumptions")
    if told.splitlines() != [CLOSED] * len(theorems):
        raise ProofError(f"a theorem rests on an assumption:\n{told}".rstrip())
    return theorems


def run(folder, *command, **options):
    result = subprocess.run(command, cwd=folder, stderr=subprocess.PIPE, text=True, check=False, **options)
    if result.returncode:
        raise ProofError(f"{' '.join(map(str, command))} fails:\n{result.stderr}".rstrip())


def compare(root, work, program, seed):
    """Compares the answers of the extracted functions with those of the C++. Throws ProofError at the first that differs."""
    shutil.copy(root / "tests/proof/proved_sweep.ml", work)
    (work / "proved.mli").unlink(missing_ok=True)
    run(work, "ocamlfind", "ocamlopt", "-package", "zarith", "-linkpkg", "proved.ml", "proved_sweep.ml", "-o", PROVED)
    run(work, program, str(COUNT), str(seed), "queries", "answers")
    with (work / "queries").open() as queries, (work / "proved").open("w") as proved:
        run(work, work / PROVED, stdin=queries, stdout=proved)
    with (work / "queries").open() as queries, (work / "answers").open() as answers, (work / "proved").open() as proved:
        for number, (query, answer, right) in enumerate(zip(queries, answers, proved, strict=True), 1):
            if answer != right:
                raise ProofError(f"query {number} of seed {seed}: {query}the C++ answers {answer}proved is {right}".rstrip())
        if number != COUNT:
            raise ProofError(f"{number} queries instead of {COUNT}")


def answers_otherwise(program, work, seed):
    """Whether an answer to the same queries is not the proved one, or the routes of the C++ differ."""
    asked = [program, str(COUNT), str(seed), "faulty_queries", "faulty_answers"]
    result = subprocess.run(asked, cwd=work, stderr=subprocess.PIPE, text=True, check=False)
    if result.returncode == 1 and "answers otherwise" in result.stderr:
        return True
    if result.returncode:
        raise ProofError(f"{program} ends with {result.returncode}: {result.stderr}".rstrip())
    if not filecmp.cmp(work / "faulty_queries", work / "queries", shallow=False):
        raise ProofError(f"{program} draws other queries than the program without a fault")
    return not filecmp.cmp(work / "faulty_answers", work / "proved", shallow=False)


def compile_sources(tree, sources, suffix):
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        command = ["g++", "-std=c++20", "-O1", "-w", "-I.", "-Ishared/include", "-c"]
        list(pool.map(lambda source: run(tree, *command, source, "-o", source + suffix), sources))


def require_that_faults_are_seen(root, work, seed):
    tree = work / "faulty"
    for folder in FOLDERS:
        shutil.copytree(root / folder, tree / folder)
    compile_sources(tree, SOURCES, ".o")

    def is_seen(changed):
        compile_sources(tree, changed, ".faulty.o")
        run(tree, "g++", *(source + (".faulty.o" if source in changed else ".o") for source in SOURCES), "-o", "faulty")
        return answers_otherwise(tree / "faulty", work, seed)

    if is_seen([]):
        raise ProofError("built here, the C++ without a fault answers otherwise")
    for fault in FAULTS:
        file = tree / fault.file
        text = file.read_text(encoding="utf-8")
        if text.count(fault.original) != 1:
            raise ProofError(f"{fault.name}: its original text occurs {text.count(fault.original)} times in {fault.file}, not once")
        file.write_text(text.replace(fault.original, fault.replaced), encoding="utf-8")
        seen = is_seen([fault.file] if fault.file in SOURCES else SOURCES)
        file.write_text(text, encoding="utf-8")
        if not seen:
            raise ProofError(f"{fault.name} gives no other answer: {fault.breaks}")


def main(arguments):
    if len(arguments) != 3:
        sys.exit(__doc__)
    root, program = Path(arguments[0]).resolve(), Path(arguments[1]).resolve()
    seed = int(arguments[2])
    work = root / "build/proof"
    try:
        theorems = check(root / "shared/proof", work)
        print(f"{len(theorems)} theorems in {len({name for name, _ in theorems})} files hold, and none rests on an assumption", flush=True)
        compare(root, work, program, seed)
        print(f"{COUNT} queries of seed {seed}: the C++ answers as what is proved", flush=True)
        require_that_faults_are_seen(root, work, seed)
    except ProofError as error:
        sys.exit(str(error))
    print(f"{len(FAULTS)} deliberate faults: each gives another answer")


if __name__ == "__main__":
    main(sys.argv[1:])
