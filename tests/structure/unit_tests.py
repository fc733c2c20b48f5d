"""The rules that every unit of the product has a test file of its name, that a CMakeLists.txt names every test file, and
the units that are excepted."""

import re

UNIT_FOLDERS = ("shared/", "protocol/", "server/", "client/", "levels/")
PROGRAM_FOLDERS = ("shared/examples/",)  # package_test.py builds and runs them

# {unit: which tests check it instead}
EXCEPTIONS = {
    "client/bot/bot_main.cpp": "tests/net/programs runs platon-bot",
    "client/gl/paint/sky_painter.cpp": "renderer_test compares its pixels",
    "client/gl/overlay_painter.cpp": "renderer_test compares its pixels",
    "client/gl/paint/face_painter.cpp": "renderer_test compares its pixels",
    "protocol/files/file_replacement.cpp": "text_file_test",
    "client/play/main.cpp": "tests/net/programs runs platon-client",
    "client/play/match_screen.cpp": "window_match_test and window_play_test play in it",
    "levels/tool/main.cpp": "check_command_test runs platon-level",
    "server/program/main.cpp": "server_program_test runs platon-server",
}


def _stem(path):
    return path.rpartition("/")[2].removesuffix(".cpp")


def check_units(paths, exceptions=None):
    """Yields a violation for each unit without a test of its name, and for each needless exception."""
    exceptions = EXCEPTIONS if exceptions is None else exceptions
    sources = [path for path in paths if path.endswith(".cpp") and path.startswith(UNIT_FOLDERS)]
    units = [path for path in sources if not path.startswith(PROGRAM_FOLDERS)]
    tests = {_stem(path) for path in paths if path.startswith("tests/") and path.endswith("_test.cpp")}
    for unit in units:
        tested = f"{_stem(unit)}_test" in tests
        if not tested and unit not in exceptions:
            yield f"{unit}:1: no test file is called {_stem(unit)}_test.cpp; add it, or say why in tests/structure/unit_tests.py"
        if tested and unit in exceptions:
            yield f"{unit}:1: it has a test file: delete its exception from tests/structure/unit_tests.py"
    for unit in sorted(set(exceptions) - set(units)):
        yield f"{unit}:1: it does not exist: delete its exception from tests/structure/unit_tests.py"


def check_registered(files):
    """Yields a violation for each test file that is built by no CMakeLists.txt of its folder or of one above it. `files`:
    {path: text}."""
    builds = {
        path.rpartition("/")[0]: re.sub(r"#.*", "", text) for path, text in files.items() if path.endswith("CMakeLists.txt")
    }
    for path in files:
        if not path.endswith("_test.cpp"):
            continue
        parts = path.split("/")
        above = (("/".join(parts[:depth]), "/".join(parts[depth:])) for depth in range(len(parts)))
        if not any(re.search(rf"(?<![\w./-]){re.escape(name)}(?![\w./-])", builds.get(folder, "")) for folder, name in above):
            yield f"{path}:1: no CMakeLists.txt names it, so it is never built: add it to platon_tests in that of its folder"
