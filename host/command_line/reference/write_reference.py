"""write_reference.py FOLDER PROGRAM...: writes the manual pages of the programs into FOLDER/man1 and completions for
shells into FOLDER/bash, FOLDER/zsh and FOLDER/fish.
write_reference.py --page PROGRAM...: prints docs/reference/commands.md."""

import pathlib
import sys

import command_trees
import completions
import man_pages


def write(folder, files):
    """Makes `folder` hold these files and no others."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


def main(target, *programs):
    trees = command_trees.read(programs)
    folder = pathlib.Path(target)
    write(folder / "man1", man_pages.pages(trees))
    for shell, files in completions.files(trees).items():
        write(folder / shell, files)


if __name__ == "__main__":
    main(*sys.argv[1:])
