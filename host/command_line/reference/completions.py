"""Completions for bash, zsh and fish: commands, options, and values where the program knows them or they are files."""

import re

import command_trees as trees


def inner_names(tree, command):
    """(name, its help) of each command below one, other names too."""
    for inner in trees.inner_commands(tree, command):
        for name in (inner["name"].rsplit(" ", 1)[1], *inner["other_names"]):
            yield name, inner["help"]


def choices(option):
    """Values to offer, where they are few."""
    if option["names"] == ["--device"]:
        return ["cpu", "gpu"]
    return option.get("choices", [])


def kind(option):
    return "choice" if choices(option) else option["value"]


def function_name(name):
    return "_" + re.sub(r"\W", "_", name)


def single_quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


# bash

BASH = """\
# bash completion of @program@. It needs no other script. Made from what `@program@ --print-commands` prints.
@function@() {
  local IFS=$' \\t\\n' command=@program@ current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  local commands= options= kind= choices= positional= i
  # --option=value is three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
@paths@
    esac
  done
  case $command in
@commands@
  esac
  COMPREPLY=()
  if [[ -z $kind && $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  case ${kind:-${commands:+command}} in
    choice) COMPREPLY=($(compgen -W "$choices" -- "$current")) ;;
    command) COMPREPLY=($(compgen -W "$commands" -- "$current")) ;;
    '') kind=$positional ;;
  esac
  # Readline completes names of files itself where there is nothing else, spaces and quotation marks included.
  case $kind in
    file) ;;
    folder) compopt +o default -o dirnames 2>/dev/null ;;
    *) compopt +o default 2>/dev/null ;;
  esac
}
complete -o default -F @function@ @program@
"""


def bash_command(tree, command):
    lines = []
    if words := [name for name, _ in inner_names(tree, command)]:
        lines.append(f"commands='{' '.join(words)}'")
    names = [name for option in command["options"] for name in option["names"]]
    lines.append(f"options='{' '.join(names)}'")
    if command["positionals"]:
        lines.append(f"positional={command['positionals'][0]['value']}")
    cases = {}
    for option in command["options"]:
        if trees.takes_value(option):
            found = f"kind={kind(option)}"
            if choices(option):
                found += f" choices='{' '.join(choices(option))}'"
            cases.setdefault(found, []).extend(option["names"])
    if cases:
        lines.append("case $previous in")
        lines += [f"  {' | '.join(names)}) {found} ;;" for found, names in cases.items()]
        lines.append("esac")
    body = "\n".join(f"      {line}" for line in lines)
    return f"    '{command['name']}')\n{body}\n      ;;"


def bash(tree):
    inner = tree["commands"][1:]
    paths = []
    for command in inner:
        outer = command["name"].rsplit(" ", 1)[0]
        names = [command["name"], *(f"{outer} {name}" for name in command["other_names"])]
        paths.append(f"      {' | '.join(single_quoted(name) for name in names)}) command='{command['name']}' ;;")
    return (
        BASH.replace("@paths@", "\n".join(paths) or "      *) ;;")
        .replace("@commands@", "\n".join(bash_command(tree, command) for command in tree["commands"]))
        .replace("@function@", function_name(tree["program"]))
        .replace("@program@", tree["program"])
    )


# zsh


def zsh_text(text):
    """The first line of a help text, as specifications of _arguments and _describe take it."""
    return re.sub(r"([\\\[\]:])", r"\\\1", text.split("\n")[0])


def zsh_action(option):
    if choices(option):
        return f"({' '.join(choices(option))})"
    return {"file": "_files", "folder": "_files -/"}.get(option["value"], " ")


def zsh_option(option):
    help_text = f"[{zsh_text(option['help'])}]"
    value = f":{zsh_text(option['placeholder'])}:{zsh_action(option)}" if trees.takes_value(option) else ""
    repeats = option.get("max_count", 1) > 1
    others = "" if repeats else f"({' '.join(option['names'])})"
    specs = []
    for name in option["names"]:
        joined = ("=" if name.startswith("--") else "+") if value else ""
        specs.append(single_quoted(f"{'*' if repeats else others}{name}{joined}{help_text}{value}"))
    return specs


def zsh_function(tree, command):
    specs = [spec for option in command["options"] for spec in zsh_option(option)]
    name = function_name(command["name"])
    inner = list(inner_names(tree, command))
    if not inner:
        specs += [
            single_quoted(f"{number}:{zsh_text(option['placeholder'])}:{zsh_action(option)}")
            for number, option in enumerate(command["positionals"], 1)
        ]
        return f"{name}() {{\n  _arguments -s -S \\\n    " + " \\\n    ".join(specs) + "\n}\n"
    specs += ["'1: :->command'", "'*:: :->arguments'"]
    described = "\n".join(f"        {single_quoted(f'{word}:{zsh_text(text)}')}" for word, text in inner)
    cases = "\n".join(
        f"        {' | '.join([below['name'].rsplit(' ', 1)[1], *below['other_names']])})"
        f" {function_name(below['name'])} ;;"
        for below in trees.inner_commands(tree, command)
    )
    arguments = " \\\n    ".join(specs)
    return f"""{name}() {{
  local curcontext=$curcontext state line
  typeset -A opt_args
  _arguments -C -S \\
    {arguments}
  case $state in
    command)
      local -a commands=(
{described}
      )
      _describe command commands
      ;;
    arguments)
      case $line[1] in
{cases}
      esac
      ;;
  esac
}}
"""


def zsh(tree):
    program = tree["program"]
    functions = "\n".join(zsh_function(tree, command) for command in reversed(tree["commands"]))
    # The file is the body of the function when it is loaded by name.
    return (
        f"#compdef {program}\n# Made from what `{program} --print-commands` prints.\n\n{functions}\n"
        f'{function_name(program)} "$@"\n'
    )


# fish

FISH = """\
# Made from what `@program@ --print-commands` prints.
function @function@_is_at
    set -l known @known@
    set -l at @program@
    for word in (commandline -opc)[2..]
        if contains -- "$at $word" $known
            set at "$at $word"
        end
    end
    test "$at" = "$argv"
end

complete -c @program@ -f
"""


def fish_text(text):
    return "'" + text.split("\n")[0].replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_lines(tree, command, at):
    start = f"complete -c {tree['program']} -n '_{function_name(tree['program'])}_is_at {at}'"
    for name, text in inner_names(tree, command):
        yield f"{start} -a {name} -d {fish_text(text)}"
    if any(option["value"] == "file" for option in command["positionals"]):
        yield f"{start} -F"
    elif command["positionals"]:
        yield f"{start} -x -a '(__fish_complete_directories)'"
    for option in command["options"]:
        names = [f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}" for name in option["names"]]
        value = ""
        if choices(option):
            value = f" -x -a '{' '.join(choices(option))}'"
        elif trees.takes_value(option):
            value = {"file": " -r -F", "folder": " -x -a '(__fish_complete_directories)'"}.get(option["value"], " -x")
        yield f"{start} {' '.join(names)}{value} -d {fish_text(option['help'])}"


def fish(tree):
    places = []  # a command by each of its names
    for command in tree["commands"]:
        outer, _, _ = command["name"].rpartition(" ")
        places.append((command["name"], command))
        places += [(f"{outer} {name}", command) for name in command["other_names"]]
    head = (
        FISH.replace("@function@", "_" + function_name(tree["program"]))
        .replace("@known@", " ".join(f"'{name}'" for name, _ in places[1:]) or "''")
        .replace("@program@", tree["program"])
    )
    return head + "\n".join(line for at, command in places for line in fish_lines(tree, command, at)) + "\n"


def files(all_trees):
    """The files of each shell by their names."""
    return {
        "bash": {tree["program"]: bash(tree) for tree in all_trees},
        "zsh": {"_" + tree["program"]: zsh(tree) for tree in all_trees},
        "fish": {f"{tree['program']}.fish": fish(tree) for tree in all_trees},
    }
