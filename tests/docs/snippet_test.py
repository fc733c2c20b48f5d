#!/usr/bin/env python3
"""Compiles the C++ snippet of README.md against the public headers, runs it and compares what it prints.

usage: snippet_test.py ROOT COMPILER LIBRARY…
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

SNIPPET = re.compile(r'<!-- snippet: .* it prints "(?P<output>[^"]*)" -->\n```cpp\n(?P<code>.*?)```', re.DOTALL)


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    root, compiler, *libraries = arguments
    found = SNIPPET.search((Path(root) / "README.md").read_text(encoding="utf-8"))
    if not found:
        print("README.md has no snippet with its output")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder) / "snippet.cpp", Path(folder) / "snippet"
        source.write_text(found["code"], encoding="utf-8")
        flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", f"-I{root}/shared/include"]
        subprocess.run([compiler, *flags, source, *libraries, "-o", program], check=True)
        output = subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()
    if output != found["output"]:
        print(f"the snippet of README.md prints '{output}', not '{found['output']}'")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
