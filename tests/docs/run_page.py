"""Runs the commands of a documentation page as its reader would, in order, in a scratch folder with a copy of the shipped
scenes. Fails at the first command that fails. docs/contributing.md says how a page marks its blocks.

usage: run_page.py PAGE --programs BIN_DIR --sources ROOT [--bpy PYTHON] [--limit-s S] [--keep FOLDER]
"""

import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FENCE = re.compile(r"(`{3,})\s*([^`]*)$")
COMMENT = re.compile(r"<!-- *(not run|run with): *(.*?) *-->$")
LIST_ITEM = re.compile(r"\s*(?:[-*+]|\d+[.)])\s")
NEEDS = re.compile(r"# needs: (\S+)$")
BLENDER = "blender --background --python "  # in front of the script that a Python with the module bpy runs instead


class PageFault(Exception):
    """A page that cannot be run, or a command on it that failed; `line` counts from 1."""

    def __init__(self, line, text):
        super().__init__(text)
        self.line = line


class Block:
    """A fenced block: `marker` is the kind and the value of the comment before it, or nothing."""

    def __init__(self, line, info, marker):
        self.line, self.marker, self.lines = line, marker, []
        self.language, *self.names = info.split()

    @property
    def text(self):
        return "".join(line + "\n" for line in self.lines)


def read_blocks(text):
    """The fenced blocks of a page; faults what no reader of the page would know how to run."""
    blocks, fence, marker, before, is_list = [], None, None, "", False
    for number, line in enumerate(text.splitlines(), 1):
        found = FENCE.match(line)
        if fence:
            if found and not found[2] and len(found[1]) >= len(fence):
                fence = None
            else:
                blocks[-1].lines.append(line)
        elif found:
            if not found[2]:
                raise PageFault(number, "a fence without a language: say sh, text, or a language and a file name")
            fence = found[1]
            blocks.append(Block(number, found[2], marker and marker[1:]))
            marker = None
        elif COMMENT.match(line):
            marker = (number, *COMMENT.match(line).groups())
            if not marker[2] or (marker[1] == "run with" and marker[2] != "bpy"):
                raise PageFault(number, "expected <!-- not run: REASON --> or <!-- run with: bpy -->")
        elif re.match(r"\s+```", line):
            raise PageFault(number, "an indented fence: begin it in the first column")
        elif line.startswith("    ") and not before and not is_list:
            raise PageFault(number, "an indented block, which is not run: use a fence")
        elif marker and line:
            raise PageFault(marker[0], "no fence follows this comment")
        if not fence and line and not line.startswith("  "):
            is_list = bool(LIST_ITEM.match(line))
        before = line
    if fence:
        raise PageFault(blocks[-1].line, "this fence does not end")
    if marker:
        raise PageFault(marker[0], "no fence follows this comment")
    return blocks


class Page:
    def __init__(self, blocks, scratch, programs, bpy, limit_s):
        self.blocks, self.scratch, self.bpy, self.limit_s = blocks, scratch.resolve(), bpy, limit_s
        self.environment = dict(os.environ, PATH=f"{programs}{os.pathsep}{os.environ['PATH']}")
        self.started = set()  # files that a block of this page has begun

    def run(self, report):
        """Runs all blocks; calls report(block, what was done)."""
        commands = 0
        for block in self.blocks:
            is_shell = block.language in ("sh", "bash")
            if is_shell:
                self.bash(block, "-n")
            if len(block.names) > 1 or (block.language in ("sh", "text") and block.names):
                raise PageFault(block.line, "expected sh, text, or a language and one file name")
            if block.marker and block.marker[0] == "not run":
                report(block, f"not run: {block.marker[1]}")
            elif block.names:
                self.append(block)
                report(block, f"to {block.names[0]}")
            elif block.language == "sh":
                commands += 1
                report(block, self.run_commands(block))
            elif block.language != "text":
                raise PageFault(block.line, f"give the {block.language} block a file name, or say why it is not run")
        if not commands:
            raise PageFault(1, "no command to run: the page needs no test")

    def append(self, block):
        file = (self.scratch / block.names[0]).resolve()
        if not file.is_relative_to(self.scratch):
            raise PageFault(block.line, f"{block.names[0]}: expected a file in the reader's folder")
        file.parent.mkdir(parents=True, exist_ok=True)
        with open(file, "a" if file in self.started else "w", encoding="utf-8") as output:
            output.write(block.text)
        self.started.add(file)

    def run_commands(self, block):
        """Runs an sh block; returns its seconds, or why it was skipped."""
        needs = NEEDS.match(block.lines[0]) if block.lines else None
        if needs and not shutil.which(needs[1], path=self.environment["PATH"]):
            return f"skipped: no program {needs[1]}"
        text = "".join(line + "\n" for line in block.lines if not line.startswith("./dev "))
        if block.marker:
            if BLENDER not in text:
                raise PageFault(block.line, f"expected a line {BLENDER}FILE")
            if not self.has_bpy():
                return "skipped: no Python with the module bpy"
            text = text.replace(BLENDER, f"'{self.bpy}' ")
        start = time.monotonic()
        self.bash(block, "-eo", "pipefail", "-c", text)
        return f"{time.monotonic() - start:.1f} s"

    def has_bpy(self):
        if not self.bpy or not shutil.which(self.bpy):
            return False
        return subprocess.run([self.bpy, "-c", "import bpy"], capture_output=True, check=False).returncode == 0

    def bash(self, block, *words):
        """Runs bash; what it started is ended with it. The block itself is its input if it only reads."""
        text = block.text if words == ("-n",) else ""
        with subprocess.Popen(["bash", *words], cwd=self.scratch, env=self.environment, text=True, errors="replace",
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              start_new_session=True) as shell:
            try:
                output, errors = shell.communicate(text, timeout=self.limit_s)
                fault = f"exit code {shell.returncode}" if shell.returncode else ""
            except subprocess.TimeoutExpired:
                os.killpg(shell.pid, signal.SIGKILL)
                output, errors = shell.communicate()
                fault = f"more than {self.limit_s:g} s"
        if fault:
            raise PageFault(block.line, f"{fault}\n{block.text}--- output\n{output[-4000:]}--- errors\n{errors[-4000:]}")


def run_page(page, scratch, arguments):
    """Runs the page in this folder. Returns whether all went well."""
    for folder in ("scenes", "examples"):
        if (arguments.sources / folder).is_dir():
            shutil.copytree(arguments.sources / folder, scratch / folder, dirs_exist_ok=True)
    start = time.monotonic()
    try:
        blocks = read_blocks(page.read_text(encoding="utf-8"))
        Page(blocks, scratch, arguments.programs.resolve(), arguments.bpy, arguments.limit_s).run(
            lambda block, what: print(f"{page}:{block.line}: {what}", flush=True))
    except PageFault as fault:
        print(f"{page}:{fault.line}: {fault}", file=sys.stderr)
        return False
    print(f"{page}: {time.monotonic() - start:.1f} s")
    return True


def main():
    parser = argparse.ArgumentParser(description="Runs the commands of a documentation page.")
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--sources", type=pathlib.Path, required=True, help="folder that holds scenes/")
    parser.add_argument("--bpy", help="Python that has the module bpy, for blocks that run Blender")
    parser.add_argument("--limit-s", type=float, default=600, help="most time for one block (default 600)")
    parser.add_argument("--keep", type=pathlib.Path, help="run in this new folder and keep it")
    arguments = parser.parse_args()
    if arguments.keep:
        arguments.keep.mkdir(parents=True)
        return 0 if run_page(arguments.page, arguments.keep, arguments) else 1
    with tempfile.TemporaryDirectory() as folder:
        return 0 if run_page(arguments.page, pathlib.Path(folder), arguments) else 1


if __name__ == "__main__":
    sys.exit(main())
