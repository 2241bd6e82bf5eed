"""summary.py JUNIT_FILE: after a CTest run, prints each skipped test with its reason and one closing line."""

import itertools
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def skip_reason(output):
    """The text that GTEST_SKIP streamed: the lines after 'FILE:LINE: Skipped'."""
    lines = output.splitlines()
    for number, line in enumerate(lines):
        if line.endswith(": Skipped"):
            reason = itertools.takewhile(lambda text: text and not text.startswith("["), lines[number + 1 :])
            return " ".join(text.strip() for text in reason)
    return "no reason printed"


def main(path):
    if not pathlib.Path(path).exists():
        sys.exit("error: CTest ran no test and left no results\nhint: see its messages above")
    passed, failed, skipped = 0, 0, []
    for case in ElementTree.parse(path).getroot().iter("testcase"):
        if case.find("skipped") is not None:
            skipped.append((case.get("name"), skip_reason(case.findtext("system-out") or "")))
        elif case.get("status") == "run":
            passed += 1
        else:
            failed += 1
    for name, reason in skipped:
        print(f"skipped: {name}: {reason}")
    print(f"\n{passed} passed, {failed} failed, {len(skipped)} skipped")


main(sys.argv[1])
