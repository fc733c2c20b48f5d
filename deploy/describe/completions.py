"""Completions for bash, zsh and fish, made of the help of a program."""

import re

FILES = ("FILE", "PATH")
FOLDERS = ("DIR",)


def _words(page):
    """The options of a page, with two hyphens where they have them."""
    return [entry.long or entry.short for entry in page.options()]


def _choices(value):
    return value.split("|") if "|" in value else []


def bash(page):
    """Completes options, commands, choices such as on|off, and files."""
    name = page.name.replace("-", "_")
    lines = [f"# Completion of {page.name} for bash.", f"_{name}() {{", "  local current=${COMP_WORDS[COMP_CWORD]} words"]
    lines.append(f"  words='{' '.join(_words(page) + [command.name for command in page.commands])}'")
    if page.commands:
        lines.append("  case ${COMP_WORDS[1]} in")
        lines += [f"    {command.name}) words='{' '.join(_words(command))}' ;;" for command in page.commands]
        lines.append("  esac")
    lines.append("  case ${COMP_WORDS[COMP_CWORD - 1]} in")
    for entry in [each for one in (page, *page.commands) for each in one.options()]:
        if _choices(entry.value):
            lines.append(f"    {entry.long}) words='{' '.join(_choices(entry.value))}' ;;")
        elif entry.value in FOLDERS:
            lines.append(f"    {entry.long}) mapfile -t COMPREPLY < <(compgen -d -- \"$current\") && return ;;")
        elif entry.value in FILES:
            lines.append(f"    {entry.long}) mapfile -t COMPREPLY < <(compgen -f -- \"$current\") && return ;;")
    lines += ["  esac", "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")"]
    lines += [f"}}\ncomplete -o default -F _{name} {page.name}\n"]
    return "\n".join(lines)


def _zsh_text(text):
    return re.sub(r"([\[\]:])", r"\\\1", text).replace("'", "'\\''")


def _zsh_value(entry):
    if not entry.value:
        return ""
    action = f"({' '.join(_choices(entry.value))})" if _choices(entry.value) else ""
    action = action or ("_files -/" if entry.value in FOLDERS else "_files" if entry.value in FILES else " ")
    return f":{_zsh_text(entry.value)}:{action}"


def _zsh_arguments(page, indent):
    lines = [f"{indent}'{entry.long or entry.short}[{_zsh_text(entry.text)}]{_zsh_value(entry)}' \\" for entry in page.options()]
    return [f"{indent}_arguments \\", *("  " + line for line in lines), f"{indent}  '*:file:_files'"]


def zsh(page):
    lines = [f"#compdef {page.name}"]
    if page.commands:
        commands = " ".join(f"'{command.name}:{_zsh_text(command.summary)}'" for command in page.commands)
        lines += ["if (( CURRENT == 2 )); then", f"  local -a commands=({commands})", "  _describe command commands", "fi"]
        lines.append("case ${words[2]} in")
        for command in page.commands:
            lines += [f"  {command.name})", *_zsh_arguments(command, "    "), "    ;;"]
        lines += ["  *)", *_zsh_arguments(page, "    "), "    ;;", "esac"]
    else:
        lines += _zsh_arguments(page, "")
    return "\n".join(lines) + "\n"


def _fish_option(program, entry, condition):
    text = entry.text.replace("\\", "\\\\").replace("'", "\\'")
    names = (f" -l {entry.long[2:]}" if entry.long else "") + (f" -s {entry.short[1:]}" if entry.short else "")
    choices = f" -x -a '{' '.join(_choices(entry.value))}'" if _choices(entry.value) else " -r" if entry.value else ""
    return f"complete -c {program}{condition}{names}{choices} -d '{text}'"


def fish(page):
    lines = [f"# Completion of {page.name} for fish."]
    top = " -n __fish_use_subcommand" if page.commands else ""
    lines += [_fish_option(page.name, entry, top) for entry in page.options()]
    for command in page.commands:
        lines.append(f"complete -c {page.name}{top} -f -a {command.name} -d '{command.summary}'")
        seen = f" -n '__fish_seen_subcommand_from {command.name}'"
        lines += [_fish_option(page.name, entry, seen) for entry in command.options()]
    return "\n".join(lines) + "\n"
