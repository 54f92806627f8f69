"""The reference page of the command ``semref``, from its argparse parsers."""

import argparse
from pathlib import Path

HEAD = Path(__file__).with_name("heads").joinpath("command_line.md").read_text(encoding="utf-8")


def page() -> str:
    """Return the whole page."""
    from semref.core.onboard.command_line import command_parser

    parser = command_parser()
    parser.prog = "semref"
    commands = next(action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    about = {choice.dest: choice.help for choice in commands._choices_actions}
    parts = [section(f"semref {name}", about[name], command) for name, command in commands.choices.items()]
    _, _, codes = parser.epilog.partition("exit codes:")
    return "\n".join([HEAD, *parts, f"## Exit codes\n\n```text\n{codes.strip(chr(10))}\n```\n"])


def section(title: str, about: str, command: argparse.ArgumentParser) -> str:
    """Return heading, usage and a table of the arguments of a command."""
    rows = []
    for action in command._actions:
        if isinstance(action, argparse._HelpAction):
            continue
        values = action.metavar or ("{" + ",".join(action.choices) + "}" if action.choices else "")
        values = " ".join(values) if isinstance(values, tuple) else values
        name = " ".join(filter(None, [", ".join(action.option_strings), values if action.nargs != 0 else ""]))
        rows.append(f"| `{name or action.dest.upper()}` | {_cell(action.help)} |")
    usage = command.format_usage().partition(": ")[2].replace("\n       ", "\n").strip()
    usage = f"{title}{usage[usage.index(' ', usage.index(command.prog.split()[-1])) :]}"
    head = f"## {title}\n\n{about[:1].upper()}{about[1:]}.\n\n```text\n{usage}\n```\n"
    return "\n".join([head, "| argument | meaning |", "|---|---|", *rows, ""])


def _cell(text: str) -> str:
    return (text[:1].upper() + text[1:]).replace("%%", "%").replace("|", "\\|").replace("<", "&lt;") + "."
