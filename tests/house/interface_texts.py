"""What programmers read beside names: the comments of host/c/offing.h and the docstrings of python/."""

import ast
import inspect
import re

HEADER = "host/c/offing.h"
COMMENT = re.compile(r"/\*\*?<?(.*?)\*/", re.DOTALL)


def interface_texts(repository):
    """Path, number of the first line, and text of each."""
    if HEADER in repository.files:
        text = repository.text(HEADER)
        for match in COMMENT.finditer(text):
            lines = [re.sub(r"^ +\* ?", "", line) for line in match[1].splitlines()]  # tables stay indented
            yield HEADER, text.count("\n", 0, match.start()) + 1, "\n".join(lines)
    for path in repository.under("python", suffixes=(".py",)):
        for node in ast.walk(ast.parse(repository.text(path))):
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node) is not None:
                yield path, node.body[0].lineno, inspect.cleandoc(node.body[0].value.value)
