"""The pages docs/reference/PROGRAM.md: all commands of a program with their options."""

import re

import command_trees as trees

HEAD = """\
# {program}

All commands of `{program}` with their options. `./dev docs` writes this page from the program. Manual pages
(`man {last}`) and `--help`, which every command takes, have the same text.

"""


def cell(text):
    """Text of a table, line breaks kept."""
    return re.sub(r"([|*<\\])", r"\\\1", text).replace("\n", "<br>")


def anchor(command):
    return command["name"].replace(" ", "-")


def table(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(row) + " |"
    yield ""


def option_table(group, options):
    head = ["option" if group == "Options" else group, "meaning", "value", "default"]
    rows = [
        [
            f"`{trees.flags_with_value(option)}`",
            cell(option["help"]) + (" (required)" if option["is_required"] else ""),
            cell(option.get("expected", "")),
            cell(option.get("default", "")),
        ]
        for option in options
        if "--help" not in option["names"]
    ]
    columns = 4 if any("expected" in option for option in options) else 2
    return table(head[:columns], [row[:columns] for row in rows]) if rows else []


def command_lines(tree, command):
    yield f"## {command['name']}\n"
    names = "".join(f" Other name: `{name}`." for name in command["other_names"])
    yield f"{trees.sentence(command['help'])}{names}\n"
    yield f"    {' '.join([command['name'], *trees.synopsis(tree, command)])}\n"
    if inner := trees.inner_commands(tree, command):
        yield from table(
            ["command", "does"], [[f"[{below['name']}](#{anchor(below)})", cell(below["help"])] for below in inner]
        )
    if command["positionals"]:
        yield from table(
            ["argument", "meaning"],
            [
                [f"`{option['placeholder']}`", cell(option["help"]) + (" (required)" if option["is_required"] else "")]
                for option in command["positionals"]
            ],
        )
    for group, options in trees.by_group(command["options"]).items():
        yield from option_table(group, options)
    for block in trees.prose(command):
        if isinstance(block, str):
            yield f"{cell(block)}\n"
        else:
            yield from table(["name", "meaning"], [[cell(name), cell(text)] for name, text in block])
    if examples := trees.examples(command):
        yield "Examples:\n"
        yield from (f"    {line}" for line in examples)
        yield ""


def page(tree):
    lines = [line for command in tree["commands"] for line in command_lines(tree, command)]
    lines.append("## Exit codes\n")
    lines += table(["code", "meaning"], [[code, meaning] for code, meaning in trees.exit_codes(tree).items()])
    variables = {}
    for command in tree["commands"]:
        variables |= trees.environment_of(command)
    if variables:
        lines.append("## Environment\n")
        lines += table(["variable", "meaning"], [[f"`{name}`", cell(text)] for name, text in variables.items()])
    head = HEAD.format(program=tree["program"], last=trees.page_name(tree["commands"][-1]))
    return head + "\n".join(lines).rstrip() + "\n"
