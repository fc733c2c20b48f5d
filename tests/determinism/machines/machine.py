"""The machines on which the simulation must give equal hashes: how to build for each and run its programs."""

import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]

# Seconds.
BUILD_TIMEOUT = 1800

_NEED = re.compile(r"^(?P<package>\S+)\s+(?P<probe>(?:tool|file):\S+)$", re.MULTILINE)


class MachineError(Exception):
    """A sentence that says why a machine cannot be used."""


@dataclass(frozen=True)
class Machine:
    """One way to build and run platon-sim. `needs` are probes in the package lists of ./platon."""

    name: str
    what: str
    needs: tuple
    options: tuple
    runner: tuple = ()
    program: str = "bin/platon-sim"

    def command(self, builds, arguments):
        """The command that runs platon-sim with these arguments on this machine."""
        return [*self.runner, str(Path(builds) / self.name / self.program), *map(str, arguments)]

    def missing(self):
        """The probes of missing tools and files."""
        return [probe for probe in self.needs if not _found(probe)]

    def check(self):
        """Raises MachineError, with the packages to install, if anything is missing."""
        missing = self.missing()
        if missing:
            names = ", ".join(probe.partition(":")[2] for probe in missing)
            packages = " ".join(package_of(probe) for probe in missing)
            raise MachineError(f"{self.name} needs {names}, not found here: apt-get install {packages}")

    def build(self, builds, jobs, launcher):
        """Builds platon-sim. Raises MachineError, with the end of the output, on failure."""
        self.check()
        directory = Path(builds) / self.name
        configure = ["cmake", "-S", ROOT, "-B", directory, "-G", "Ninja", *_COMMON, *self.options]
        if launcher:
            configure.append(f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}")
        self._step("configure", configure)
        self._step("build", ["cmake", "--build", directory, "--target", "platon-sim", "--parallel", str(jobs)])

    def _step(self, what, command):
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=BUILD_TIMEOUT)
        if done.returncode != 0:
            end = "\n".join((done.stdout + done.stderr).splitlines()[-40:])
            raise MachineError(f"{self.name}: {what} failed:\n{end}")


def _found(probe):
    kind, _, name = probe.partition(":")
    return shutil.which(name) is not None if kind == "tool" else os.path.exists(name)


def package_of(probe, platon=ROOT / "platon"):
    """The Debian package of a probe, from the package lists of ./platon."""
    for need in _NEED.finditer(platon.read_text(encoding="utf-8")):
        if need["probe"] == probe:
            return need["package"]
    raise KeyError(f"{platon} has no package for {probe}")


# Several files at a time take a third of the time.
_COMMON = ("-DPLATON_SIM_ONLY=ON", "-DPLATON_INSTALL=OFF", "-DBUILD_TESTING=OFF", "-DCMAKE_UNITY_BUILD=ON")
_TOOLS = ("tool:cmake", "tool:ninja")


def _native(name, what, compiler, kind, flags, sanitize=""):
    need = {"g++": "tool:c++"}.get(compiler, f"tool:{compiler}")
    options = (f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_BUILD_TYPE={kind}", f"-DPLATON_SANITIZE={sanitize}",
               f"-DCMAKE_CXX_FLAGS_{kind.upper()}={flags}")  # fmt: skip
    return Machine(name, what, (*_TOOLS, need), options)


def _emulated(name, what, triple, emulator):
    # The recordings take seconds, so most of the time goes into compiling. Static linking avoids a search for libraries
    # under emulation.
    options = (f"-DCMAKE_TOOLCHAIN_FILE={HERE / name}.cmake", "-DCMAKE_BUILD_TYPE=Release",
               "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DCMAKE_EXE_LINKER_FLAGS=-static")  # fmt: skip
    needs = (*_TOOLS, f"tool:{triple}-linux-gnu-g++", "tool:qemu-s390x")  # one package holds all emulators
    return Machine(name, what, needs, options, (emulator,))


def _wasm(name, what):
    needs = (*_TOOLS, "tool:clang++", "tool:ld.lld", "tool:node", "file:/usr/lib/wasm32-wasi/libc.a",
             "file:/usr/lib/wasm32-wasi/libc++.a", "file:/usr/lib/wasm32-wasi/libc++abi.a",
             "file:/usr/lib/llvm-14/lib/clang/14.0.6/lib/wasi/libclang_rt.builtins-wasm32.a")  # fmt: skip
    options = (f"-DCMAKE_TOOLCHAIN_FILE={HERE / name}.cmake", "-DCMAKE_BUILD_TYPE=Release")
    return Machine(name, what, needs, options, ("node", "--no-warnings", str(HERE / "wasi_run.mjs")))


MACHINES = {
    machine.name: machine
    for machine in (
        _native("gcc_o0", "x86-64, GCC -O0, assertions", "g++", "Debug", "-O0"),
        _native("gcc_o3", "x86-64, GCC -O3", "g++", "Release", "-O3 -DNDEBUG"),
        _native("clang", "x86-64, Clang -O2", "clang++", "Release", "-O2 -DNDEBUG"),
        _native("asan", "x86-64, Clang, address and undefined-behaviour sanitizers", "clang++", "Debug", "-O1",
                "address,undefined"),
        _native("tsan", "x86-64, GCC, thread sanitizer", "g++", "Debug", "-O1", "thread"),
        _emulated("aarch64", "ARM, 64 bits, char unsigned, GCC", "aarch64", "qemu-aarch64"),
        _emulated("riscv64", "RISC-V, 64 bits, char unsigned, GCC", "riscv64", "qemu-riscv64"),
        _emulated("ppc64le", "POWER, 64 bits, char unsigned, GCC", "powerpc64le", "qemu-ppc64le"),
        _emulated("s390x", "IBM Z, 64 bits, big-endian, char unsigned, GCC", "s390x", "qemu-s390x"),
        _wasm("wasm32", "WebAssembly, pointers of 32 bits, Clang and libc++, under Node.js"),
    )
}  # fmt: skip
