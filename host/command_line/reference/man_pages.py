"""Manual pages in the macros of man(7), one a command."""

import command_trees as trees

SPECIAL = {"\\": r"\e", "-": r"\-", "'": r"\(aq", "`": r"\(ga", "^": r"\(ha", "~": r"\(ti", '"': r"\(dq"}


def escaped(text):
    """Text as it is: no character is a request, a quotation mark or a hyphen that is set as another sign."""
    text = "".join(SPECIAL.get(c, c if c.isascii() else rf"\[u{ord(c):04X}]") for c in text)
    return rf"\&{text}" if text.startswith(".") else text


def bold(text):
    return rf"\fB{escaped(text)}\fR"


def italic(text):
    return rf"\fI{escaped(text)}\fR"


def paragraph_lines(text):
    """The lines of a help text, each on its own line of the page."""
    return "\n.br\n".join(escaped(line) for line in text.split("\n"))


def entry(head, text):
    return [".TP", head, paragraph_lines(text)]


def option_head(option):
    head = ", ".join(bold(name) for name in option["names"])
    if trees.takes_value(option):
        head += f" {italic(option['placeholder'])}"
    return head + (" (required)" if option["is_required"] else "")


def option_text(option):
    if "expected" not in option:
        return option["help"]
    return f"{option['help']}\n{option['expected']}; default {option['default']}"


def synopsis(tree, command):
    words = [bold(command["name"])]
    for word in trees.synopsis(tree, command):
        flag, _, value = word.partition(" ")
        if flag.startswith("-"):
            words.append(f"{bold(flag)} {italic(value)}")
        elif word.startswith("["):
            words.append(f"[{italic(word[1:-1])}]")
        else:
            words.append(italic(word))
    return " ".join(words)


def description(command):
    lines = [escaped(trees.sentence(command["help"]))]
    for block in trees.prose(command):
        if isinstance(block, str):
            lines += [".PP", escaped(block)]
        else:
            for name, text in block:
                lines += entry(bold(name), text)
    return lines


def see_also(all_trees, tree, command):
    names = [trees.page_name(other["commands"][0]) for other in all_trees if other is not tree]
    words = command["name"].split(" ")
    names += ["-".join(words[:count]) for count in range(1, len(words))]
    return sorted(names)


def page(all_trees, tree, command):
    name = trees.page_name(command)
    lines = [
        r'.\" Made by host/command_line/reference from the options of the program.',
        f'.TH {escaped(name.upper())} 1 "" "Offing {escaped(tree["version"])}" "User commands"',
        ".ad l",
        ".nh",
        ".SH NAME",
        rf"{escaped(name)} \- {escaped(command['help'])}",
        ".SH SYNOPSIS",
        synopsis(tree, command),
        ".SH DESCRIPTION",
        *description(command),
    ]
    if inner := trees.inner_commands(tree, command):
        lines.append(".SH COMMANDS")
        for below in inner:
            text = below["help"]
            if below["other_names"]:
                text += f"\nother name: {', '.join(below['other_names'])}"
            lines += entry(f"{bold(trees.page_name(below))}(1)", text)
    lines.append(".SH OPTIONS")
    for option in command["positionals"]:
        lines += entry(italic(option["placeholder"]) + (" (required)" if option["is_required"] else ""), option["help"])
    for group, options in trees.by_group(command["options"]).items():
        if group != "Options":
            lines.append(f".SS {escaped(group)}")
        for option in options:
            lines += entry(option_head(option), option_text(option))
    if examples := trees.examples(command):
        lines += [".SH EXAMPLES", ".nf", *(escaped(line) for line in examples), ".fi"]
    lines.append(".SH EXIT STATUS")
    for code, meaning in trees.exit_codes(tree).items():
        lines += entry(bold(code), meaning)
    if environment := trees.environment_of(command):
        lines.append(".SH ENVIRONMENT")
        for variable, text in environment.items():
            lines += entry(bold(variable), text)
    lines.append(".SH SEE ALSO")
    lines.append(",\n".join(f"{bold(other)}(1)" for other in see_also(all_trees, tree, command)))
    return "\n".join(lines) + "\n"


def pages(all_trees):
    """{"offing-ocean-bake.1": text}."""
    return {
        f"{trees.page_name(command)}.1": page(all_trees, tree, command)
        for tree in all_trees
        for command in tree["commands"]
    }
