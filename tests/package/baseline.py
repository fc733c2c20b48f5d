"""The instructions of a program that the oldest machines of Debian's amd64 lack."""

import re
import subprocess

# Of SSE3 and later, AVX, BMI, and those that x86-64-v2 adds. "tzcnt" is not among them: older machines run it as bsf.
LATER = re.compile(
    r"\t(?P<word>(?:"
    r"fisttp\w*|lddqu|mov(?:d|sh|sl)dup|h(?:add|sub)p[sd]|addsubp[sd]"
    r"|pabs[bwd]|palignr|pshufb|ph(?:add|sub)\w+|pmaddubsw|pmulhrsw|psign[bwd]"
    r"|p?blend\w+|dpp[sd]|extractps|insertps|movntdqa|mpsadbw|packusdw|pcmp(?:eq|gt)q|pextr[bdq]|pinsr[bdq]|phminposuw"
    r"|p(?:max|min)(?:sb|sd|uw|ud)|pmov[sz]x\w+|pmuldq|pmulld|ptest|round[ps][ds]"
    r"|pcmp[ei]str[im]|crc32\w*|popcnt\w*|lzcnt\w*|movbe|cmpxchg16b|lahf|sahf"
    r"|andn|bextr|bls(?:i|r|msk)|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx|v[a-z]\w+"
    r")\b)")


def later_in(listing):
    """The names of those in a listing of objdump, in alphabetical order."""
    return sorted({found["word"] for found in LATER.finditer(listing)})


def later_instructions(program):
    """The names of those that the program has, in alphabetical order."""
    command = ["objdump", "--disassemble", "--no-show-raw-insn", str(program)]
    return later_in(subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout)
