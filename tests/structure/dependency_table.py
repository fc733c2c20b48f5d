"""The tables of docs/architecture.md, which define the allowed dependencies."""

import fnmatch
import re


class TableError(Exception):
    """A table is missing or malformed."""


def _cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def _names(cell):
    return re.findall(r"`([^`]+)`", cell)


def _table(text, name):
    """The rows of the table under `<!-- table: name -->`, each a list of cells."""
    lines = iter(text.splitlines())
    for line in lines:
        if line.strip() == f"<!-- table: {name} -->":
            break
    rows = []
    for line in lines:
        if not line.startswith("|"):
            break
        rows.append(_cells(line))
    if len(rows) < 3:
        raise TableError(f"no table under '<!-- table: {name} -->'")
    for row in rows:
        if len(row) != len(rows[0]):
            raise TableError(f"table {name}: {len(row)} cells instead of {len(rows[0])} in the row of {row[0]}")
    return rows[2:]


def _matches(path, patterns):
    return any(fnmatch.fnmatchcase(path, pattern) for pattern in patterns)


PUBLIC_HEADERS = "shared/include/"


def path_of(header):
    """The path, from the root of the tree, of a file that is included as `header`."""
    return PUBLIC_HEADERS + header if header.startswith("platon/") else header


class DependencyTable:
    """The three tables: folders, headers and words."""

    def __init__(self, text):
        self._folders = {}
        for row in _table(text, "folders"):
            names = _names(row[0])
            if len(names) != 1:
                raise TableError(f"table folders: one folder a row, not {row[0]}")
            self._folders[names[0]] = [path_of(name + "/")[:-1] for name in _names(row[2])]
        self._refuse_cycles()
        self._headers = [(_names(row[0]), _names(row[1])) for row in _table(text, "headers")]
        self._words = [(_names(row[0]), _names(row[1])) for row in _table(text, "words")]

    def _refuse_cycles(self):
        """Raises TableError if a folder may include one of a later row: dependencies go one way."""
        seen = set()
        for folder, allowed in self._folders.items():
            for name in allowed:
                for other in self._folders:
                    if (other + "/").startswith(name + "/") and other != folder and other not in seen:
                        raise TableError(f"table folders: {folder} may include {other}, whose row comes later")
            seen.add(folder)

    def folders(self):
        """Every folder that has a row."""
        return list(self._folders)

    def folder_of(self, path):
        """The folder with a row that holds the file; None if there is none."""
        rows = [folder for folder in self._folders if path_of(path).startswith(folder + "/")]
        return max(rows, key=len, default=None)

    def may_include_folder(self, path, header):
        """True if the row of the file's folder allows it to include this file of the project."""
        folder = self.folder_of(path)
        if folder and self.folder_of(header) == folder:
            return True
        return any(path_of(header).startswith(name + "/") for name in self._folders.get(folder, []))

    def may_include_header(self, path, header):
        """True if the table of headers allows this file to include the header."""
        for headers, files in self._headers:
            named = any(name in ("*", header) or (name.endswith("/") and header.startswith(name)) for name in headers)
            if named and _matches(path, files):
                return True
        return False

    def forbidden_words(self, path):
        """The words that this file may not contain."""
        return {word for words, files in self._words if not _matches(path, files) for word in words}
