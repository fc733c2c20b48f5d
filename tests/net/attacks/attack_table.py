"""The table of attacks in docs/security.md, and its limits."""

from pathlib import Path

MISSED = 1  # inputs per 1000 ticks, more than without an attack
JOIN_MS = 2000
P99_MS = 8
GROWTH = 1024 * 1024
REACHED = 99  # per cent
AMPLIFICATION = 4

HEAD = """| attack | what it does | datagrams | reached, % | answered, % of bytes | amplified, × | missed inputs per 1000 | disconnected | newcomer joins, ms | tick p50 / p99 / longest, ms | memory, KiB | CPU, % |
|---|---|---|---|---|---|---|---|---|---|---|---|"""


def _row(result):
    join = "never" if result.join is None else f"{result.join:.0f}"
    cells = [
        f"`{result.attack['name']}`",
        result.attack["does"],
        f"{result.sent:,}".replace(",", " "),
        f"{result.reached:.1f}",
        f"{100 * result.answered_ratio:.0f}",
        "" if result.amplification is None else f"{result.amplification:.1f}",
        f"{result.missed:.2f}",
        f"{result.disconnected}",
        join,
        f"{result.p50:.2f} / {result.p99:.1f} / {result.longest:.1f}",
        f"{result.growth / 1024:+.0f}",
        f"{result.cpu:.0f}",
    ]
    return f"| {' | '.join(cells)} |"


def table(results, seconds):
    """Markdown. The first result is that without an attack."""
    buffer = int(Path("/proc/sys/net/core/rmem_max").read_text())
    lines = [f"Each attack lasts {seconds} s. The system allows receive buffers of {buffer // 1024} KiB.", "", HEAD, *(_row(result) for result in results)]
    failed = exceeded(results)
    if failed:
        lines += ["", "Exceeded:", "", *(f"- {line}" for line in failed)]
    return "\n".join(lines)


def _exceeded(result):
    name = result.attack["name"]
    if result.disconnected or result.desyncs:
        yield f"{name}: {result.disconnected} players disconnected, {result.desyncs} desyncs"
    if result.answered_ratio > 1:
        yield f"{name}: more bytes answered than asked"
    if (result.amplification or 0) > AMPLIFICATION:
        yield f"{name}: sent back {result.amplification:.1f} times the bytes of the attacker, more than {AMPLIFICATION}"


def _exceeded_with_time(result, quiet):
    """Limits that a slow or busy machine exceeds too."""
    name = result.attack["name"]
    if result.missed > quiet.missed + MISSED:
        yield f"{name}: {result.missed:.2f} missed inputs per 1000 ticks, without an attack {quiet.missed:.2f}"
    if result.join is None or result.join > JOIN_MS:
        yield f"{name}: a newcomer does not join within {JOIN_MS} ms"
    if result.p99 > P99_MS:
        yield f"{name}: p99 of a tick {result.p99:.1f} ms, more than {P99_MS}"
    if result.growth > max(quiet.growth, 0) + GROWTH:
        yield f"{name}: memory grew by {result.growth // 1024} KiB"
    if result.reached < REACHED:
        yield f"{name}: only {result.reached:.1f} % reached the server"


def exceeded(results, timings=True):
    """A sentence for each limit that is exceeded. Without `timings`, only of limits that hold on any machine."""
    lines = []
    for result in results:
        lines += _exceeded(result)
        lines += _exceeded_with_time(result, results[0]) if timings else []
    return lines
