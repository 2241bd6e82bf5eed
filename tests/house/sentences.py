"""Sentences of pages, of help texts, of the C interface's comments and of Python's docstrings have at most 30 words. Code,
tables, lists and headings are left out of pages; the help texts are the cells of the tables in docs/reference, which are
made from the programs."""

import re

from interface_texts import interface_texts
from repository import run

MOST_WORDS = 30
# A point in these ends no sentence.
SHORT_FORMS = re.compile(r"\b(e\.g|i\.e|etc|vs|cf|al|eq|fig|no|sec)\.", re.IGNORECASE)
LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
CODE = re.compile(r"`[^`]*`|\$[^$\n]+\$")
LIST = re.compile(r"^\s*(?:[-*+]|\d+\.)\s")


def words_in(sentence):
    return len(re.findall(r"[^\s\-–/=+*|<>]*\w[^\s]*", sentence))


def long_sentences(text):
    """The sentences of a paragraph that have too many words."""
    text = CODE.sub("X", LINK.sub(r"\1", text))
    text = SHORT_FORMS.sub(r"\1", re.sub(r"(\d)\.(\d)", r"\1,\2", text))
    for sentence in re.split(r"[.?!](?=\s|$|[\"')*])", text):
        count = words_in(sentence)
        if count > MOST_WORDS:
            yield count, " ".join(sentence.split())


def paragraphs(text):
    """Line number and text of each paragraph that is prose."""
    lines, start, in_fence, in_list = [], 0, False, False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        is_fence = line.lstrip().startswith("```")
        in_list = bool(LIST.match(line)) or (in_list and line.startswith("  "))
        is_prose = not (
            in_fence or is_fence or in_list or not line.strip() or line.startswith(("    ", "|", "#", "<!--", ">"))
        )
        in_fence ^= is_fence
        if is_prose:
            start = start or number
            lines.append(line)
        elif lines:
            yield start, "\n".join(lines)
            lines, start = [], 0


def cells(text):
    """Line number and text of each cell of tables."""
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("|"):
            for cell in re.split(r"(?<!\\)\|", line):
                # A line of a help text stands by itself.
                yield from ((number, line_of_cell) for line_of_cell in cell.split("<br>"))


def check(repository):
    pages = [path for path in repository.under("docs", "examples", suffixes=(".md",)) if path != "docs/changes.md"]
    pages += [path for path in ("README.md", "kernels/README.md") if path in repository.files]
    texts = [(path, 1, repository.text(path)) for path in pages] + list(interface_texts(repository))
    return [
        f"{path}:{first + number - 1}: a sentence of {count} words, {MOST_WORDS} at most: {sentence[:90]}"
        for path, first, text in texts
        for parts in [cells if path.startswith("docs/reference/") else paragraphs]
        for number, part in parts(text)
        for count, sentence in long_sentences(part)
    ]


if __name__ == "__main__":
    run(check)
