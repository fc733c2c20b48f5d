"""The tables of docs/architecture.md, which say what may depend on what."""

import fnmatch
import re


class TableError(Exception):
    """The page lacks a table or a table cannot be understood."""


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


def place_of(header):
    """Where an included file of the project lies, from the root of the tree."""
    return PUBLIC_HEADERS + header if header.startswith("platon/") else header


class DependencyTable:
    """Answers from the three tables: folders, headers and words."""

    def __init__(self, text):
        self._folders = {}
        for row in _table(text, "folders"):
            names = _names(row[0])
            if len(names) != 1:
                raise TableError(f"table folders: one folder a row, not {row[0]}")
            self._folders[names[0]] = [place_of(name + "/")[:-1] for name in _names(row[2])]
        self._refuse_cycles()
        self._headers = [(_names(row[0]), _names(row[1])) for row in _table(text, "headers")]
        self._words = [(_names(row[0]), _names(row[1])) for row in _table(text, "words")]

    def _refuse_cycles(self):
        """Every folder comes after those that it may include, so that dependencies go one way."""
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
        """The folder, of those with a row, that holds the file; None when there is none."""
        return next((folder for folder in self._folders if place_of(path).startswith(folder + "/")), None)

    def may_include_folder(self, path, header):
        """True when the row of the file's folder lets it include this file of the project."""
        folder = self.folder_of(path)
        allowed = [folder] + self._folders.get(folder, [])
        return any(place_of(header).startswith(name + "/") for name in allowed if name)

    def may_include_header(self, path, header):
        """True when the table of headers lets this file include it."""
        for headers, files in self._headers:
            named = any(name in ("*", header) or (name.endswith("/") and header.startswith(name)) for name in headers)
            if named and _matches(path, files):
                return True
        return False

    def forbidden_words(self, path):
        """The words that this file may not use."""
        return {word for words, files in self._words if not _matches(path, files) for word in words}
