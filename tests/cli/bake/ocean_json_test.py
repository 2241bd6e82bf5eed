"""ocean_json_test.py OFFING SCHEMA: ocean.json of each layout is what docs/ocean.schema.json says. Fails if a field is
missing, is of another type or is not in the schema, or if the schema accepts a description without one of its fields."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77  # SKIP_RETURN_CODE of this test

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(SKIPPED)

SEA = ["--size", "16", "--patch-m", "200,23", "--frames", "2:3", "--fps", "8", "--quiet"]
GERSTNER = ["--gerstner-count", "4", "--gerstner-split-m", "60"]
BAKES = {
    "usual": [],
    "combined": ["--layout", "combined", "--half", "--loop-period-s", "2", "--depth-m", "30", "--mesh", "ply"],
    "rgb": ["--layout", "rgb", "--axes", "z-up", "--velocity", *GERSTNER],
    "wakes": ["--wakes", "--velocity", "--gerstner-count", "0"],
    "whole": ["--channels", "displacement,normal", "--include-gerstner", *GERSTNER],
}

offing = pathlib.Path(sys.argv[1]).resolve()
schema = json.loads(pathlib.Path(sys.argv[2]).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for name, flags in BAKES.items():
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "wake.toml"
        scene.write_text("version = 1\n[ocean]\n[[ocean.wake]]\ncells = 16\nhistory_s = 0.5\n")
        subprocess.run([offing, "ocean", "bake", scene, *SEA, *flags, "-o", folder], check=True, stderr=subprocess.DEVNULL)
        description = json.loads((pathlib.Path(folder) / "ocean.json").read_text())
        validator.validate(description)
        assert len(description["wakes"]) == ("--wakes" in flags), name
        for place in description["cascades"] + description["wakes"]:
            for a_map in place["maps"].values():
                assert (pathlib.Path(folder) / (a_map["file"] % 3)).exists(), (name, a_map)
    for field in description:
        without = copy.deepcopy(description)
        del without[field]
        assert not validator.is_valid(without), (name, field)
