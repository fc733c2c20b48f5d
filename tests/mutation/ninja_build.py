"""Builds test programs with changed sources from the commands of a Ninja build, without writing into its directory."""

import os
import shlex
import subprocess
from functools import cached_property


class BuildError(Exception):
    """The directory is not a Ninja build, or not up to date with the tree."""


class Program:
    """The commands that compile the objects of a program and of its libraries, and the command that links it."""

    def __init__(self, commands):
        self.objects = {}
        for command in commands:
            # Ninja's link command is ": && LINKER … && :"; a custom build step comes after the linker.
            words = shlex.split(command.removeprefix(": && ").split(" && ")[0])
            if "-o" not in words:
                continue
            output = following(words, "-o")
            if "-c" in words:
                self.objects[output] = words
            elif output.startswith("tests/bin/"):  # the others are programs that the test runs
                self.link, self.path = words, output


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


class NinjaBuild:
    def __init__(self, directory, root):
        self._directory = directory.resolve()
        self._root = root.resolve()
        self._programs = {}
        if not (self._directory / "build.ninja").is_file():
            raise BuildError(f"{directory} has no build.ninja: build with a preset, which uses Ninja")

    def program(self, name):
        if name not in self._programs:
            self._programs[name] = Program(self._ninja("commands", name).splitlines())
        return self._programs[name]

    def executable(self, name):
        return self._directory / self.program(name).path

    def require_up_to_date(self, name):
        """Raises BuildError if a source is newer than the program."""
        program = self.program(name)
        executable = self.executable(name)
        if not executable.is_file():
            raise BuildError(f"{name} is not built")
        built = executable.stat().st_mtime
        for source in {source for unit in program.objects for source in self._sources.get(unit, ())}:
            if not os.path.exists(source) or os.stat(source).st_mtime > built:
                raise BuildError(f"{name} is older than {source}: build first")

    def with_overlay(self, name, file, overlay):
        """Compiles the sources that depend on `file`, which is taken from the folder `overlay`, and links the program.

        Returns the path of the program in `overlay`, or None if it does not build.
        """
        program = self.program(name)
        changed = {}
        for unit, command in program.objects.items():
            if str(self._root / file) not in self._sources.get(unit, ()):
                continue
            changed[unit] = str(overlay / f"{len(changed)}.o")
            alone = self._alone(command, unit, name)
            if not self._run(self._compile(alone, changed[unit], file, overlay)):
                return None
        if not changed:
            raise BuildError(f"{name} does not depend on {file}")
        return overlay / "program" if self._run(self._link(program, changed, overlay / "program")) else None

    def _alone(self, command, unit, name):
        """The command, for the test file of this name alone where it is compiled together with others."""
        place = command.index("-c") + 1
        test = [file for file in self._sources[unit] if os.path.basename(file) == f"{name}.cpp"]
        return command[:place] + test + command[place + 1 :] if test else command

    def _compile(self, command, output, file, overlay):
        """Finds quoted includes in the overlay first; without warnings, and without optimisation that costs time."""
        command = without_dependency_files(command)
        command[command.index("-o") + 1] = output
        source = command.index("-c") + 1
        if self._absolute(command[source]) == str(self._root / file):
            command[source] = str(overlay / file)
        command = [word for word in command if word.split("=")[0] not in ("-flto", "-ffat-lto-objects")]
        return command + ["-w", "-O1", "-iquote", str(overlay), "-iquote", str(overlay / "shared/include")]

    def _link(self, program, changed, output):
        """Names changed objects before the libraries, where they replace those inside."""
        command = without_dependency_files(program.link)
        command[command.index("-o") + 1] = str(output)
        named = [changed[unit] for unit in changed if unit not in command]
        command = [changed.get(word, word) for word in command]
        place = command.index("-o")
        return command[:place] + named + command[place:]

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

    def _run(self, command):
        environment = dict(os.environ, CCACHE_DISABLE="1")
        result = subprocess.run(command, cwd=self._directory, env=environment, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)  # fmt: skip
        if result.returncode != 0:
            print("\n".join(result.stdout.splitlines()[-20:]))
        return result.returncode == 0
