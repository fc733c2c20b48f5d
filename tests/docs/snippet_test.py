#!/usr/bin/env python3
"""Compiles the C++ snippets of the docs against the public headers, runs them and compares what they print.

usage: snippet_test.py ROOT COMPILER LIBRARY…
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pages

SNIPPET = re.compile(r'<!-- snippet: .* it prints "(?P<output>[^"]*)" -->\n```cpp\n(?P<code>.*?)```', re.DOTALL)
WITH_SNIPPETS = {"README.md", "docs/physics.md"}


def output_of(code, root, compiler, libraries):
    """What the program prints."""
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder) / "snippet.cpp", Path(folder) / "snippet"
        source.write_text(code, encoding="utf-8")
        flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", f"-I{root}/shared/include"]
        subprocess.run([compiler, *flags, source, *libraries, "-o", program], check=True)
        return subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    root, compiler, *libraries = arguments
    tested = set()
    wrong = 0
    for page, text in pages.pages(Path(root)):
        for snippet in SNIPPET.finditer(text):
            tested.add(page.as_posix())
            output = output_of(snippet["code"], root, compiler, libraries)
            if output != snippet["output"]:
                print(f"the snippet of {page} prints '{output}', not '{snippet['output']}'")
                wrong += 1
    for page in sorted(WITH_SNIPPETS - tested):
        print(f"{page} has no snippet with its output")
    return 1 if wrong or WITH_SNIPPETS - tested else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
