"""write_reference.py FOLDER PROGRAM...: writes the manual pages of the programs into FOLDER/man1 and completions for
shells into FOLDER/bash, FOLDER/zsh and FOLDER/fish.
write_reference.py --pages FOLDER PROGRAM...: writes a page a program, as in docs/reference."""

import pathlib
import sys

import command_trees
import completions
import man_pages
import program_pages


def write(folder, files):
    """Makes `folder` hold these files and no others."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


def main(*arguments):
    writes_pages = arguments[0] == "--pages"
    target, *programs = arguments[writes_pages:]
    folder, trees = pathlib.Path(target), command_trees.read(programs)
    if writes_pages:
        for tree in trees:
            (folder / f"{tree['program']}.md").write_text(program_pages.page(tree), encoding="utf-8")
        return
    write(folder / "man1", man_pages.pages(trees))
    for shell, files in completions.files(trees).items():
        write(folder / shell, files)


if __name__ == "__main__":
    main(*sys.argv[1:])
