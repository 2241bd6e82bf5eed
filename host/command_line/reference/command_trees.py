"""What programs print for --print-commands (host/command_line/command_tree.h), read and taken apart for pages."""

import json
import re
import subprocess

# Variables of the environment, and the option of the commands that read them. A test compares them with the sources.
ENVIRONMENT = {
    "OFFING_DEVICE": ("device", "OpenCL device to use without --device, in the same forms."),
    "OFFING_CACHE_DIR": (
        "device",
        "Folder for compiled kernels, generated terrain, the sky visibility of maps and tables of the air. The default is $XDG_CACHE_HOME/offing, or "
        "~/.cache/offing. If it is set to nothing, all are made in each run.",
    ),
    "OFFING_MODULE_PATH": (
        "help",
        "Folder of the modules for GDAL, OpenVDB, NetCDF and fonts. The default is the folder "
        "offing beside the libraries.",
    ),
    "OFFING_SHAPE": ("device", "simd or workgroup: the family of kernels to use. The default suits the device."),
    "OFFING_KERNEL_PATH": ("device", "Folder kernels of a checkout, whose kernels replace those built in."),
    "OFFING_SHADER_PATH": ("sources", "Folder present/passes of a checkout, whose shaders replace those built in."),
    "OFFING_HOST_POINTERS": (
        "device",
        "0: no buffer uses host memory. For drivers and tools that fail with such buffers.",
    ),
    "OFFING_LONGEST_WAIT_S": (
        "device",
        "Longest time in seconds for the work before a first picture or frame. Longer work is refused. The default is "
        "45.",
    ),
}


def read(programs):
    trees = [
        json.loads(subprocess.run([program, "--print-commands"], check=True, stdout=subprocess.PIPE).stdout)
        for program in programs
    ]
    for tree in trees:  # "offing-view: sea, ground, ...": pages have the name beside it
        first = tree["commands"][0]
        first["help"] = re.sub(rf"^{tree['program']}: ", "", first["help"], flags=re.IGNORECASE)
    return trees


def page_name(command):
    return command["name"].replace(" ", "-")


def inner_commands(tree, command):
    """The commands directly below one."""
    depth = command["name"].count(" ") + 1
    return [
        inner
        for inner in tree["commands"]
        if inner["name"].startswith(command["name"] + " ") and inner["name"].count(" ") == depth
    ]


def takes_value(option):
    return option["value"] != "none"


def flags_with_value(option):
    """"-o, --output DIR"."""
    return ", ".join(option["names"]) + (f" {option['placeholder']}" if takes_value(option) else "")


def synopsis(tree, command):
    """The words after the name of a command: required options, the others, then what follows."""
    words = [
        f"{option['names'][-1]} {option['placeholder']}" for option in command["options"] if option["is_required"]
    ]
    words.append("[OPTION...]")
    words += [
        option["placeholder"] if option["is_required"] else f"[{option['placeholder']}]"
        for option in command["positionals"]
    ]
    return words + ["COMMAND ..."] * bool(inner_commands(tree, command))


def sentence(text):
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def by_group(options):
    groups = {}
    for option in options:
        groups.setdefault(option["group"], []).append(option)
    return groups


def environment_of(command):
    options = {name for option in command["options"] for name in option["names"]}
    return {name: text for name, (option, text) in ENVIRONMENT.items() if f"--{option}" in options}


def exit_codes(tree):
    """{"0": "done", ...}, which the help of the program itself ends with."""
    line = re.search(r"^Exit codes: (.*)\.$", tree["commands"][0]["footer"], re.MULTILINE)[1]
    return dict(code.split(" ", 1) for code in line.split(", "))


def prose(command):
    """Paragraphs below the options, each a text or a list of names with their meanings; without examples."""
    blocks = []
    for block in command["footer"].strip("\n").split("\n\n"):
        lines = block.split("\n")
        if not block.strip() or re.match(r"Examples?:|Exit codes:", block):
            continue
        if all(re.match(r"  +\S.*?\S?  +\S", line) for line in lines):
            blocks.append([re.split(r"  +", line.strip(), maxsplit=1) for line in lines])
        else:
            blocks.append(" ".join(line.strip() for line in lines))
    return blocks


def examples(command):
    """Lines of the shell."""
    found = re.search(r"^Examples?:\n((?:  .*\n?)+)", command["footer"], re.MULTILINE)
    return [line[2:].rstrip() for line in found[1].splitlines()] if found else []
