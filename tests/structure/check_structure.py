#!/usr/bin/env python3
"""Checks the structure of the tree: includes, the purity of shared/, lengths, leftovers, that units have tests and are built.

usage: check_structure.py ROOT [PLAN]. Prints each violation as `file:line: what`; exit 1 if there are any. PLAN: plan.json of
a build of the tree; without it the newest in ROOT/build.
"""

import fnmatch
import os
import re
import sys
from pathlib import Path

import source_text
from check_includes import PAGE, check_includes, check_page, read_plan, table
from unit_tests import check_registered, check_units

MAX_FILE_LINES = 600

TOP_LEVEL = {
    "CMakeLists.txt", "shared", "server", "client", "protocol", "levels", "tests", "deploy",
    "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "LICENSE", "CMakePresets.json", "platon", "docs", "build", "CMakeUserPresets.json",
}  # fmt: skip

CPP_SUFFIXES = {".h", ".cpp"}
CODE_SUFFIXES = CPP_SUFFIXES | {".py", ".sh", ".cmake", ".fbs", ".vert", ".frag", ".glsl"}
TEXT_SUFFIXES = CODE_SUFFIXES | {".md", ".txt", ".json", ".toml", ".yml", ".yaml", ".level", ".service"}

PURE_HEADERS = set(
    """algorithm array bit cassert charconv climits compare concepts cstddef cstdint cstdlib cstring deque exception
    functional initializer_list iterator limits list map memory new numeric optional queue set source_location span
    stack stdexcept string string_view system_error tuple type_traits utility variant vector version""".split()
)

# Refused in shared/, qualified or not.
IMPURE_WORDS = set(
    """float double unordered_map unordered_set unordered_multimap unordered_multiset chrono gettimeofday clock_gettime
    rand srand random_device mt19937 mt19937_64 minstd_rand cout cerr clog cin printf fprintf puts fputs fopen fread
    fwrite ifstream ofstream fstream ostream istream stringstream ostringstream istringstream spdlog getenv setlocale
    thread_local stof stod stold atof strtof strtod strtold __float128 _Float16 _Float32 _Float64 _Float128 _Decimal32
    _Decimal64 _Decimal128
    long wchar_t reinterpret_cast bit_cast uintptr_t intptr_t memcpy memmove memcmp memset offsetof typeid type_index
    this_thread pthread_self priority_queue make_heap push_heap pop_heap sort_heap""".split()
)

# Refused in shared/ as names of the standard library only: World has a member hash.
IMPURE_STANDARD_NAMES = set("hash time clock random thread mutex atomic locale system shuffle sample partition".split())

# Names refused in shared/: compiler built-ins, and random distributions, which differ between libraries.
IMPURE_NAMES = re.compile(r"__builtin_\w+|__sync_\w+|__atomic_\w+|\w+_distribution")

# Code whose result depends on how a machine lays out or places its objects.
BIT_FIELD = re.compile(r"^(?![ \t]*(?:case|class|struct|enum)\b)[\w: \t]*\w[ \t]+[A-Za-z_]\w*[ \t]*:[ \t]*\w+[ \t]*[;,{=]",
                       re.MULTILINE)  # fmt: skip
ADDRESS_ORDER = re.compile(r"std::(?:(?:multi)?(?:map|set)\s*<[^;(){},]*?(?:\*|_ptr\s*<)"
                           r"|(?:less|greater|owner_less)\s*<[^;(){}]*?\*)")  # fmt: skip
LAYOUT = (
    (BIT_FIELD, "the layout of a bit-field depends on the compiler"),
    (ADDRESS_ORDER, "an order by address differs from run to run"),
)

# These may include everything: tests, and programs that use the installed library.
NOT_OF_THE_PLAN = ("tests/", "shared/examples/")

LEFTOVERS = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b")
MACHINE_PATHS = re.compile(r"(?<![\w./$}-])/(?:home|root|work|Users|builds|workspace)/[\w.]")
FILE_NAME = re.compile(r"[a-z0-9]+(?:_[a-z0-9]+)*\.(?:h|cpp)")


def tree_files(root):
    """Yields (path relative to root, content) of every text file, except build outputs."""
    for directory, names, files in os.walk(root):
        relative = Path(directory).relative_to(root)
        names[:] = sorted(n for n in names if n not in (".git", "__pycache__") and (relative / n).as_posix() != "build")
        for name in sorted(files):
            path = relative / name
            if path.suffix in TEXT_SUFFIXES or path.as_posix() in ("platon", ".ci/run"):
                yield path.as_posix(), (root / path).read_text(encoding="utf-8", errors="replace")


def check_top_level(root):
    for entry in sorted(os.listdir(root)):
        if entry not in TOP_LEVEL and not entry.startswith("."):
            yield f"{entry}:1: no such file belongs at the top level: move it into a folder"


def check_words(path, text, rows):
    """Yields every name that the page allows only in other files."""
    code = source_text.code_of(text)
    for words, places in rows:
        allowed = any(fnmatch.fnmatchcase(path, place) for place in re.findall(r"`([^`]+)`", places))
        pattern = "|".join(re.escape(word) + r"\b" for word in re.findall(r"`([^`]+)`", words))
        for match in () if allowed else re.finditer(pattern, code):
            yield f"{path}:{source_text.line_of(code, match.start())}: '{match.group()}' may not be used here"


def check_threads(path, text, page):
    """A class that has a worker is in the table of threads."""
    if not path.endswith(".h") or path.startswith(("protocol/work/", "tests/")):
        return
    code = source_text.code_of(text)
    table = page.partition("\n### Threads\n")[2].partition("\n## ")[0]
    owners = {}
    for match in re.finditer(r"\bWorker<\w", code):
        classes = re.findall(r"^(?:class|struct) (\w+)", code[: match.start()], re.MULTILINE)
        owners.setdefault(classes[-1] if classes else path, match.start())
    for owner, place in owners.items():
        if f"`{owner}`" not in table:
            yield f"{path}:{source_text.line_of(code, place)}: {owner} has a worker, but no row in the table of threads in {PAGE}"


# What a player chooses: (struct, how objects of it are called, its header, the files that only keep and change the
# choice). A member that no other file of the client reads has no effect.
CHOICES = (
    ("Settings", "[sS]ettings", "client/ui/settings.h", ("client/ui/setting*", "client/files/settings_file.*")),
    ("Quality", "[qQ]uality", "client/quality/quality.h", ("client/quality/*",)),
)


def check_choices(product):
    """Yields every member of the structs in CHOICES that has no effect."""
    client = {path: source_text.code_of(text) for path, text in product.items() if path.startswith("client/")}
    for struct, owner, header, keepers in CHOICES:
        code = client.get(header, "")
        body = re.search(rf"^struct {struct} {{$(.*?)^}};$", code, re.MULTILINE | re.DOTALL)
        users = " ".join(text for path, text in client.items() if not any(fnmatch.fnmatchcase(path, keeper) for keeper in keepers))
        for member in re.finditer(r"^  (?!static|friend)[\w:<>]+ (\w+)(?: = [^;(]*)?;", body[1] if body else "", re.MULTILINE):
            if not re.search(rf"{owner}_?(?:\(\))?(?:\.|->){member[1]}\b(?!\s*=[^=])", users):
                line = source_text.line_of(code, body.start(1) + member.start())
                yield f"{header}:{line}: nothing obeys {struct}::{member[1]}"


def check_purity(path, text):
    for line, header, quoted in source_text.includes_of(text):
        if not quoted and header.isidentifier() and header not in PURE_HEADERS:
            yield f"{path}:{line}: shared/ may not include <{header}>"
    code = source_text.code_of(text)
    for offset, word in source_text.words_of(code):
        name = word.removeprefix("std::")
        of_standard = word != name and name in IMPURE_STANDARD_NAMES
        if name in IMPURE_WORDS or of_standard or IMPURE_NAMES.fullmatch(name):
            yield f"{path}:{source_text.line_of(code, offset)}: '{word}' may not be used in shared/"
        elif source_text.is_float_literal(word):
            yield f"{path}:{source_text.line_of(code, offset)}: {word} is a floating-point number"
    for pattern, why in LAYOUT:
        for match in pattern.finditer(code):
            yield f"{path}:{source_text.line_of(code, match.start())}: '{match.group().strip()}': {why}"


def check_cpp_form(path, text):
    if not FILE_NAME.fullmatch(Path(path).name):
        yield f"{path}:1: the file name is not in snake_case"
    if path.endswith(".h") and "#pragma once" not in source_text.code_of(text):
        yield f"{path}:1: the header lacks #pragma once"
    name = Path(path).stem  # tests of several files are compiled together
    if name.endswith("_test") and not re.search(rf"^namespace (platon::)?(\w+::)*{name} {{$", text, re.MULTILINE):
        yield f"{path}:1: a test file has a namespace of its own: namespace platon::{name}"


def check_text(path, text):
    if Path(path).suffix in CODE_SUFFIXES or Path(path).name in ("CMakeLists.txt", "platon", "run"):
        if (lines := text.count("\n")) > MAX_FILE_LINES:
            yield f"{path}:{lines}: {lines} lines, more than {MAX_FILE_LINES}"
    for pattern, what in ((LEFTOVERS, "is a leftover"), (MACHINE_PATHS, "is a path of one machine")):
        for match in pattern.finditer(text):
            yield f"{path}:{source_text.line_of(text, match.start())}: '{match.group()}' {what}"


def check_tree(root, plan):
    """Yields every violation in the tree, except units without tests and tests that are not built."""
    page = (root / PAGE).read_text(encoding="utf-8")
    words, product = table(page, "words"), {}
    yield from check_top_level(root)
    yield from check_page(plan, page)
    for path, text in tree_files(root):
        yield from check_text(path, text)
        if Path(path).suffix in CPP_SUFFIXES:
            yield from check_cpp_form(path, text)
            yield from check_words(path, text, words)
            yield from check_threads(path, text, page)
            if not path.startswith(NOT_OF_THE_PLAN):
                product[path] = text
            if path.startswith("shared/") and path in product:
                yield from check_purity(path, text)
    yield from check_choices(product)
    yield from check_includes(plan, product, root)


def main(arguments):
    if len(arguments) not in (2, 3):
        print("usage: check_structure.py ROOT [PLAN]", file=sys.stderr)
        return 2
    try:
        root = Path(arguments[1])
        files = dict(tree_files(root))
        violations = [*check_tree(root, read_plan(root, *arguments[2:])), *check_units(list(files)), *check_registered(files)]
    except (OSError, ValueError) as error:
        violations = [f"{PAGE}:1: {error}"]
    print(*violations, f"{len(violations)} violations", sep="\n")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
