"""A man page, made of the help of a program."""

import re

TITLES = {"Positionals": "ARGUMENTS"}
EXIT_STATUS = (
    ("0", "Done."),
    ("1", "Failed, or a check did not hold. An address that is in use is a failure of the server."),
    ("2", "Wrong usage or configuration."),
    ("3", "An invalid level, recording or scene."),
)
# What programs keep where, if nobody tells them another place.
FILES = {
    "platon-client": (
        ("~/.config/platon", "Settings and keys, in $XDG_CONFIG_HOME if that is set."),
        ("~/.local/share/platon", "Runs, ghosts, best times, reached levels, known servers, secrets of sessions, the key of "
                                  "hosted games and reports of desyncs, in $XDG_DATA_HOME if that is set."),
        ("~/.local/state/platon", "The servers joined last, in $XDG_STATE_HOME if that is set."),
        ("~/.cache/platon", "Levels that servers have sent and levels of races, in $XDG_CACHE_HOME if that is set."),
    ),
    "platon-server": (
        ("/etc/platon/server.toml", "The configuration of the service platon-server."),
        ("/var/lib/platon", "The key of the service, its bans, best times and recordings."),
        ("/run/platon", "The socket of its console."),
    ),
}
PROGRAMS = {"platon-client": "6", "platon-server": "8", "platon-level": "1", "platon-bot": "1", "platon-sim": "1",
            "platon-bench": "1"}
MANUALS = {"1": "Tools of Platon", "6": "Games", "8": "System administration"}


def escape(text):
    """Text as roff prints it: a backslash, a hyphen of an option, and a dot or quote at the start of a line."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.split("\n"))


def _entry(entry):
    term = re.sub(r" (?:TEXT|REQUIRED)\b", "", entry.term) if not entry.term.startswith("-") else entry.term
    return f".TP\n.B {escape(term)}\n{escape(entry.text) or '.br'}\n"


def _group(title, entries):
    return f".SH {escape(TITLES.get(title, title.upper()))}\n" + "".join(map(_entry, entries))


def _command(page):
    parts = [f".SS {escape(page.name)}\n{escape(page.summary)}.\n.PP\n.B {escape(page.usage)}\n"]
    parts += [_entry(entry) for entries in page.groups.values() for entry in entries]
    return "".join(parts)


def _body(page):
    if page.verbatim:
        return f".SH COMMANDS\n.nf\n{escape(page.verbatim)}\n.fi\n"
    groups = "".join(_group(title, each) for title, each in page.groups.items() if title != "Subcommands")
    commands = "".join(map(_command, page.commands))
    return groups + (f".SH COMMANDS\n{commands}" if commands else "")


def _terms(title, rows):
    return f".SH {title}\n" + "".join(f".TP\n.B {escape(term)}\n{escape(text)}\n" for term, text in rows)


def _see_also(name, pages):
    others = [f".BR {escape(other)} ({section})" for other, section in PROGRAMS.items() if other != name]
    return ".SH SEE ALSO\n" + ",\n".join(others) + f"\n.PP\nThe pages in\n.BR {escape(pages)} .\n"


def man_page(page, section, version, pages):
    """The text of the page; `pages` is the folder of the docs."""
    summary = page.summary.partition(". ")[0].rstrip(".")
    usage = page.usage or f"{page.name} COMMAND [OPTIONS]"
    parts = [
        f'.TH {escape(page.name.upper())} {section} "" "Platon {version}" "{MANUALS[section]}"\n',
        f".SH NAME\n{escape(page.name)} \\- {escape(summary)}\n",
        f".SH SYNOPSIS\n.B {escape(usage)}\n",
        _body(page),
        _terms("EXIT STATUS", EXIT_STATUS),
        _terms("FILES", FILES[page.name]) if page.name in FILES else "",
        _see_also(page.name, pages),
    ]
    return "".join(parts)
