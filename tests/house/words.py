"""The vocabulary: retired words stand in no name and in no text that users see, and no two types of
headers have names that differ only by case or by a plural s."""

import collections
import re

from interface_texts import interface_texts
from repository import run

RETIRED = {
    "lid", "lids", "rung", "rungs", "puff", "puffs", "errand", "errands", "mend", "mends", "mended", "trochoid",
    "trochoids", "lamp", "lamps", "oceanscene", "oceanscenes",
}  # fmt: skip
# Others script against these: earlier scene keys and JSON fields, which still work.
EXEMPT = re.compile(r"\b(?:clouds?\.)?(?:crisp_|soft_)?puffs\b|\"lamps?\"|`lamps?`")
CODE = (".h", ".cpp", ".cl", ".clh", ".glsl", ".frag", ".vert")
TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<text>R"\(.*?\)"|"(?:\\.|[^"\\\n])*")|(?P<name>[A-Za-z_]\w*)',
    re.DOTALL,
)
TYPE = re.compile(
    r"^(?:template[^\n]*\n)?(?:class|struct|enum class|union)\s+(\w+)[^;{]*\{|^\}\s*(\w+);", re.MULTILINE
)


def words_of(name):
    spaced = re.sub(r"([a-z0-9])([A-Z])|([A-Z])([A-Z][a-z])", r"\1\3_\2\4", name)
    return [word for word in re.split(r"[\W_]+", spaced.lower()) if word]


def retired_in(text):
    words = words_of(EXEMPT.sub(" ", text))
    return [word for word in words if word in RETIRED] + ["OceanScene"] * ("OceanScene" in text)


def name_faults(repository):
    folders = ("kernels", "host", "present", "mesh_tools", "python", "tests", "examples")
    for path in repository.under(*folders, suffixes=CODE + (".py", ".sh")):
        for word in retired_in(path.rsplit(".", 1)[0].replace("/", " ")):
            yield f'{path}: the file name has the retired word "{word}"'
    for path in repository.under(*folders, suffixes=CODE):
        text = repository.text(path)
        for match in TOKEN.finditer(text):
            # What tests put into files and read from them is theirs to choose.
            if match.lastgroup == "comment" or (match.lastgroup == "text" and path.startswith("tests/")):
                continue
            for word in retired_in(match.group()):
                line = text.count("\n", 0, match.start()) + 1
                yield f'{path}:{line}: retired word "{word}" in {match.group()[:60]}'


def text_faults(repository):
    pages = [path for path in repository.under("docs", suffixes=(".md",)) if path != "docs/changes.md"]
    pages += [path for path in ("README.md", "dev") if path in repository.files]
    texts = [(path, 1, repository.text(path)) for path in pages] + list(interface_texts(repository))
    for path, first, text in texts:
        for number, line in enumerate(text.splitlines(), first):
            # A scene may call its light a lamp.
            for word in retired_in(re.sub(r'= "lamp"', "", line)):
                yield f'{path}:{number}: retired word "{word}"'


def type_faults(repository):
    places = collections.defaultdict(dict)
    for path in repository.under("kernels", "host", "present", "mesh_tools", suffixes=(".h",)):
        for match in TYPE.finditer(repository.code(path)):
            name = match.group(1) or match.group(2)
            places[name.lower().removesuffix("s")].setdefault(name, path)
    for names in places.values():
        if len(names) > 1:
            yield "types differ only by case or a plural s: " + ", ".join(
                f"{name} in {path}" for name, path in sorted(names.items())
            )


def check(repository):
    return [*name_faults(repository), *text_faults(repository), *type_faults(repository)]


if __name__ == "__main__":
    run(check)
