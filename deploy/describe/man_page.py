"""A man page, made of the help of a program."""

import re

TITLES = {"Positionals": "ARGUMENTS"}
EXIT_STATUS = (
    ("0", "Done."),
    ("1", "Failed, or a check did not hold."),
    ("2", "Wrong usage or configuration."),
    ("3", "An invalid level, recording or scene."),
)
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


def man_page(page, section, version):
    """The text of the page."""
    summary = page.summary.partition(". ")[0].rstrip(".")
    usage = page.usage or f"{page.name} COMMAND [OPTIONS]"
    parts = [
        f'.TH {escape(page.name.upper())} {section} "" "Platon {version}" "{MANUALS[section]}"\n',
        f".SH NAME\n{escape(page.name)} \\- {escape(summary)}\n",
        f".SH SYNOPSIS\n.B {escape(usage)}\n",
        _body(page),
        ".SH EXIT STATUS\n" + "".join(f".TP\n.B {code}\n{text}\n" for code, text in EXIT_STATUS),
    ]
    return "".join(parts)
