"""House rules that a pattern can hold: one exception type, no exit outside main, no two bools in a row,
device differences in quirks and tuning only."""

import re

from repository import run

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
VENDOR = r"pocl|portable computing|nvidia|amd|intel|mesa|rusticl|llvmpipe|apple|qualcomm|arm|oclgrind"
COMPARISON = r"==|!=|\b(?:find|contains|starts_with|ends_with|matches|strstr|strcmp)\w*\("

# (pattern, fault, folders it holds in, files that may)
RULES = (
    (
        re.compile(r"\bthrow\s+std::"),
        "throw offing::Error, the one exception type",
        ("host", "present", "mesh_tools", "examples"),
        re.compile(r"$^"),
    ),
    (
        re.compile(r"(?<![\w.>])(?:std::)?(?:exit|_exit|_Exit|quick_exit|abort)\s*\("),
        "only main and the handler of signals end the process; throw offing::Error",
        ("host", "present", "mesh_tools", "examples"),
        re.compile(r".*/main\.cpp|host/base/process\.cpp"),
    ),
    (
        re.compile(r"\bbool\b(?:\s+\w+)?(?:\s*=\s*\w+)?\s*,\s*(?:const\s+)?bool\b"),
        "two bools in a row are swapped unseen; use an enum or a struct",
        ("host", "present", "mesh_tools", "tests", "examples"),
        re.compile(r"$^"),
    ),
    (
        re.compile(rf'(?i)^[^\n]*(?:{COMPARISON})[^\n]*"[^"\n]*\b(?:{VENDOR})\b[^"\n]*"', re.MULTILINE),
        "what a driver needs lives in host/ocl/quirks and host/ocl/tuning only",
        ("host", "present", "mesh_tools", "examples"),
        re.compile(r"host/ocl/(quirks|tuning)\.(h|cpp)"),
    ),
)


def check(repository):
    faults = []
    for pattern, fault, folders, exempt in RULES:
        for path in repository.under(*folders, suffixes=(".h", ".cpp")):
            if exempt.fullmatch(path):
                continue
            text = COMMENT.sub(lambda match: "\n" * match.group().count("\n"), repository.code(path))
            for match in pattern.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{path}:{line}: {fault}")
    return faults


if __name__ == "__main__":
    run(check)
