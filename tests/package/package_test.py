#!/usr/bin/env python3
"""Uses the library as a stranger does: builds and runs the examples in an empty directory, and compares what they print
with the comment at their end.

usage: package_test.py installed ROOT BUILD COMPILER   against the installed library, which is moved before
       package_test.py subdirectory ROOT COMPILER      with the tree as a part of another project
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

STRICT = "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
# A user's program may do without these.
WITHOUT = "-fno-exceptions -fno-rtti"
PRINTS = re.compile(r"\n// It prints:\n((?:// .*\n)+)\Z")


def run(*command, **options):
    """Runs a command; ends the test with its output if it fails."""
    words = [str(word) for word in command]
    result = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(words)} fails:\n{result.stdout}")
    return result.stdout


def expected_of(example):
    """What the comment at the end of an example says that it prints."""
    found = PRINTS.search(example.read_text(encoding="utf-8"))
    if not found:
        sys.exit(f"{example} does not say what it prints")
    return re.sub(r"^// ", "", found[1], flags=re.MULTILINE)


def run_examples(root, folder, names):
    for name in names:
        printed = run(folder / name, cwd=folder)
        expected = expected_of(root / f"shared/examples/{name}.cpp")
        if printed != expected:
            sys.exit(f"the example {name} prints\n{printed}\nnot\n{expected}")


def build_with(source, build, compiler, *options):
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, f"-DCMAKE_CXX_COMPILER={compiler}", *options)
    run("cmake", "--build", build, "--parallel", "2")


def headers_of(prefix):
    headers = sorted(path.relative_to(prefix / "include").as_posix() for path in (prefix / "include").rglob("*.h"))
    if len(headers) < 20:
        sys.exit(f"only these headers are installed: {headers}")
    return headers


def check_headers(prefix, compiler):
    """Every installed header compiles alone and includes nothing that is not installed."""
    for header in headers_of(prefix):
        run(compiler, "-std=c++20", *STRICT.split(), f"-I{prefix}/include", "-fsyntax-only", "-x", "c++", "-",
            input=f'#include "{header}"\n#include "{header}"\n')  # fmt: skip


def pkg_config(prefix, *options):
    """What pkg-config answers about the installed library."""
    folders = {str(path.parent) for path in prefix.rglob("platon.pc")}
    return run("pkg-config", *options, "platon", env=os.environ | {"PKG_CONFIG_PATH": ":".join(folders)}).split()


def check_pkg_config(root, prefix, folder, names):
    """Programs without exceptions and RTTI, by both compilers, find all that they need by pkg-config."""
    version = re.search(r"^project\(platon VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)
    if pkg_config(prefix, "--modversion") != [version[1]]:
        sys.exit(f"pkg-config says version {pkg_config(prefix, '--modversion')}, not {version[1]}")
    every_header = "".join(f'#include "{header}"\n' for header in headers_of(prefix))
    for compiler in ("g++", "clang++"):
        command = [compiler, "-std=c++20", *STRICT.split(), *WITHOUT.split()]
        flags = pkg_config(prefix, "--cflags")
        run(*command, *flags, "-fsyntax-only", "-x", "c++", "-", input=every_header)
        for name in names:
            source = root / f"shared/examples/{name}.cpp"
            run(*command, *flags, source, *pkg_config(prefix, "--libs"), "-o", folder / name)
        run_examples(root, folder, names)


def check_paths(prefix, *places):
    """No installed text names a folder in which it was built."""
    for path in prefix.rglob("*"):
        text = path.read_text(encoding="utf-8") if path.suffix in (".cmake", ".h", ".pc") else ""
        for place in places:
            if str(place) in text:
                sys.exit(f"{path.relative_to(prefix)} names {place}")


def check_requests(prefix, folder, root):
    """find_package accepts the right version and components, and refuses others."""
    major, minor = map(int, re.search(r"project\(platon VERSION (\d+)\.(\d+)", (root / "CMakeLists.txt").read_text(encoding="utf-8")).groups())
    own = f"{major}.{minor}"
    for number, (request, accepted) in enumerate((
        (f"{own} COMPONENTS physics", True), (f"{own} COMPONENTS exact game", True), (f"{own} OPTIONAL_COMPONENTS sound", True),
        (f"{major}.{minor + 1}", False), (f"{major}.{minor - 1}", False), (f"{major + 1}", False), (f"{own} COMPONENTS sound", False),
    )):  # fmt: skip
        source = folder / f"request{number}"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(request LANGUAGES NONE)\n"
            f"find_package(platon {request})\n"
            f"if(platon_FOUND AND NOT {'TRUE' if accepted else 'FALSE'} OR NOT platon_FOUND AND {'TRUE' if accepted else 'FALSE'})\n"
            f'  message(FATAL_ERROR "find_package(platon {request}): found is ${{platon_FOUND}}")\nendif()\n',
            encoding="utf-8",
        )
        run("cmake", "-G", "Ninja", "-S", source, "-B", source / "build", f"-DCMAKE_PREFIX_PATH={prefix}")


def check_installed(folder, root, build, compiler):
    run("cmake", "--install", build, "--component", "library", "--prefix", folder / "first")
    prefix = (folder / "first").rename(folder / "moved")
    check_paths(prefix, root, build, folder / "first")
    check_requests(prefix, folder, root)
    check_headers(prefix, compiler)
    source = shutil.copytree(root / "shared/examples", folder / "examples")
    build_with(source, folder / "build", compiler, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_FLAGS={STRICT}")
    run_examples(root, folder / "build", sorted(path.stem for path in source.glob("*.cpp")))
    check_pkg_config(root, prefix, folder, ["box_on_floor", "ball_round_hexahedron"])


def check_subdirectory(folder, root, compiler):
    build_with(root / "tests/package/subdirectory", folder / "build", compiler, f"-DPLATON_ROOT={root}")
    run_examples(root, folder / "build", ["box_on_floor", "ball_round_hexahedron"])
    run(folder / "build/refusal")
    run("cmake", "--install", folder / "build", "--prefix", folder / "prefix")
    if (folder / "prefix").exists():
        sys.exit("a part of another project is installed with it unasked")


def main(arguments):
    checks = {"installed": (check_installed, 3), "subdirectory": (check_subdirectory, 2)}
    check, count = checks.get(arguments[0] if arguments else "", (None, 0))
    if check is None or len(arguments) != count + 1:
        print(__doc__, file=sys.stderr)
        return 2
    for name in ("DESTDIR", "CMAKE_PREFIX_PATH", "CMAKE_GENERATOR", "CXXFLAGS", "LDFLAGS"):
        os.environ.pop(name, None)
    places = [Path(argument).resolve() for argument in arguments[1:-1]]
    with tempfile.TemporaryDirectory(prefix="platon-package-") as folder:
        check(Path(folder), *places, arguments[-1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
