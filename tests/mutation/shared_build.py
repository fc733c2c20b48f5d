"""A Ninja build with shared libraries, in which a fault changes one library: no program need be linked again."""

import os
import re
import shlex
import subprocess
from functools import cached_property
from pathlib import Path


class BuildError(Exception):
    """The directory is not a Ninja build, or the tree does not build."""


def following(command, option):
    return command[command.index(option) + 1]


def without_dependency_files(command):
    """The command without the options that write further files."""
    left = []
    for word in command:
        if "--dependency-file=" in word:
            if left[-1] == "-Xlinker":
                left.pop()
        elif left and left[-1] in ("-MF", "-MT"):
            left.pop()
        elif word != "-MD":
            left.append(word)
    return left


class SharedBuild:
    def __init__(self, directory, root):
        self._directory = directory.resolve()
        self._root = root.resolve()
        self.objects = {}
        self.libraries = {}
        self.programs = {}
        for command in self._ninja("commands", "all").splitlines():
            # Ninja's link command is ": && LINKER … && :".
            words = shlex.split(command.removeprefix(": && ").split(" && ")[0]) if " -o " in command else []
            if "-o" not in words or "-c" not in words and not any(word.endswith(".o") for word in words):
                continue
            kind = self.objects if "-c" in words else self.libraries if "-shared" in words else self.programs
            kind[following(words, "-o")] = words
        if not self.libraries:
            raise BuildError(f"{directory} has no shared libraries: give a build with the preset 'faults'")
        self._library_of = {word: name for name, words in self.libraries.items() for word in words if word.endswith(".o")}

    def objects_of(self, file):
        """The objects of libraries that depend on a file of the tree."""
        path = str(self._root / file)
        return [unit for unit in self._library_of if path in self._sources.get(unit, ())]

    def library_of(self, unit):
        return self._library_of[unit]

    @cached_property
    def compiled(self):
        """The sources of the libraries, relative to the tree."""
        files = (self._absolute(following(self.objects[unit], "-c")) for unit in self._library_of)
        return {os.path.relpath(file, self._root) for file in files}

    def depends(self, program, file):
        """Whether the own objects of a program, not its libraries, depend on the file."""
        path = str(self._root / file)
        return any(path in self._sources.get(unit, ()) for unit in self._own_objects(program))

    def _own_objects(self, program):
        return [word for word in self.programs.get(program, ()) if word in self.objects]

    def changed_libraries(self, file, overlay, units):
        """Compiles these objects with the file in `overlay`, and links the libraries of those that changed there. Returns
        the names of the libraries, or None if something does not compile or link."""
        changed = {}
        for unit in units:
            output = str(overlay / f"{len(changed)}.o")
            if not self._quiet(self._compile(self.objects[unit], output, file, overlay)):
                return None
            if Path(output).read_bytes() != Path(self._absolute(unit)).read_bytes():
                changed[unit] = output
        libraries = {self._library_of[unit] for unit in changed}
        for library in libraries:
            command = [changed.get(word, word) for word in without_dependency_files(self.libraries[library])]
            command[command.index("-o") + 1] = str(overlay / os.path.basename(library))
            if not self._quiet(command):
                return None
        return libraries

    def link_test(self, program, name, file, overlay):
        """Compiles the objects of a program, of a test file alone, with the file in `overlay`. Returns its path or None."""
        changed = {}
        for unit in self._own_objects(program):
            if str(self._root / file) in self._sources.get(unit, ()):
                changed[unit] = str(overlay / f"{name}_{len(changed)}.o")
                alone = self._alone(self.objects[unit], unit, name)
                if not self._quiet(self._compile(alone, changed[unit], file, overlay)):
                    return None
        folder = overlay / "bin"
        folder.mkdir(exist_ok=True)
        command = without_dependency_files(self.programs[program])
        command = [changed.get(word, word) for word in command]
        command[command.index("-o") + 1] = str(folder / name)
        return folder / name if self._quiet(command) else None

    def _quiet(self, command):
        environment = dict(os.environ, CCACHE_DISABLE="1")
        result = subprocess.run(command, cwd=self._directory, env=environment, capture_output=True)
        return result.returncode == 0

    @cached_property
    def _needed(self):
        """{library or program: libraries of this build that it names}"""
        files = [name for name in (*self.libraries, *self.programs) if (self._directory / name).is_file()]
        command = ["readelf", "-d", "-W", *files]
        text = subprocess.run(command, cwd=self._directory, capture_output=True, text=True).stdout
        places = {os.path.basename(name): name for name in self.libraries}
        needed = {}
        for part in re.split(r"^File: ", text, flags=re.MULTILINE)[1:]:
            name, _, rest = part.partition("\n")
            named = re.findall(r"\(NEEDED\).*\[(.*)\]", rest)
            needed[name.strip()] = {places[library] for library in named if library in places}
        return needed

    def libraries_of(self, name):
        """All libraries of this build that a library or a program loads."""
        found = set()
        left = [name]
        while left:
            for library in self._needed.get(left.pop(), set()) - found:
                found.add(library)
                left.append(library)
        return found

    def relative(self, path):
        """The name of a program in this build, links followed, or None if the path is no program of it."""
        real = os.path.realpath(path)
        name = os.path.relpath(real, self._directory)
        return name if name in self.programs else None

    def time_of(self, names):
        """When the newest of these files was made."""
        return max((os.stat(self._directory / name).st_mtime for name in names), default=0)

    def _alone(self, command, unit, name):
        """The command, for the test file of this name alone where it is compiled together with others."""
        place = command.index("-c") + 1
        test = [file for file in self._sources[unit] if os.path.basename(file) == f"{name}.cpp"]
        return command[:place] + test + command[place + 1 :] if test else command

    def _compile(self, command, output, file, overlay):
        """Finds quoted includes in the overlay first; without warnings."""
        command = without_dependency_files(command)
        command[command.index("-o") + 1] = output
        source = command.index("-c") + 1
        if self._absolute(command[source]) == str(self._root / file):
            command[source] = str(overlay / file)
        return command + ["-w", "-iquote", str(overlay), "-iquote", str(overlay / "shared/include")]

    @cached_property
    def _sources(self):
        """{object: files it was compiled from}"""
        sources = {}
        for entry in self._ninja("deps").split("\n\n"):
            unit, *files = entry.strip().splitlines() or [""]
            sources[unit.split(": #deps")[0]] = {self._absolute(file.strip()) for file in files}
        return sources

    def _absolute(self, path):
        return os.path.normpath(self._directory / path)

    def _ninja(self, tool, *arguments):
        command = ["ninja", "-C", self._directory, "-t", tool, *arguments]
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if result.returncode != 0:
            raise BuildError(f"{self._directory}: {result.stderr.strip() or result.stdout.strip()}")
        return result.stdout

    @property
    def directory(self):
        return self._directory


def update(directory, root, jobs):
    """Configures the preset `faults` and builds all of it."""
    configured = (directory / "build.ninja").is_file()
    commands = [] if configured else [["cmake", "--preset", "faults", "-B", directory]]
    commands.append(["cmake", "--build", directory, "--parallel", str(jobs)])
    for command in commands:
        result = subprocess.run(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if result.returncode != 0:
            raise BuildError("\n".join(result.stdout.splitlines()[-40:]))
