"""Headers that host and device both read hold 4-byte scalars only: no compiler pads those differently."""

import re

from repository import run

STRUCT = re.compile(r"typedef\s+struct\s*\w*\s*\{(.*?)\}\s*(\w+)\s*;", re.DOTALL)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
SCALARS = {"float", "int", "uint", "offing_uint32", "offing_int32", "offing_float"}


def check(repository):
    faults = []
    paths = repository.under("kernels/shared", suffixes=(".h",))
    texts = {path: COMMENT.sub("", repository.text(path)) for path in paths}
    structs = {name for text in texts.values() for _, name in STRUCT.findall(text)}
    for path, text in texts.items():
        if not re.match(r"\s*#ifndef\s+(\w+)\s+#define\s+\1\b", text):
            faults.append(f"{path}: expected an #ifndef guard; OpenCL C 1.2 has no #pragma once")
        for body, name in STRUCT.findall(text):
            for member in filter(None, (part.strip() for part in body.split(";"))):
                if member.removeprefix("unsigned ").split()[0] not in SCALARS | structs:
                    faults.append(
                        f"{path}: {name}: '{member}': expected a 4-byte scalar or a shared struct"
                    )
            if not re.search(rf"static_assert\(\s*sizeof\({name}\)", text):
                faults.append(f"{path}: {name}: expected a static_assert on its size, for the host side")
    return faults


if __name__ == "__main__":
    run(check)
