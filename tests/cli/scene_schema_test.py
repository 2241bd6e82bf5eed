"""scene_schema_test.py OFFING SCENES: `offing scene schema` is a JSON Schema that accepts all shipped scenes and
the starter scene. It rejects broken scenes, and `offing scene check` rejects the same ones."""

import datetime
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

SKIPPED = 77  # SKIP_RETURN_CODE of this test

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(SKIPPED)

LIGHTS = "[[light]]\n" * 33
BROKEN = {
    "no version": "[wind]\nspeed_mps = 5\n",
    "another version": "version = 2\n",
    "misspelt key": "version = 1\n[wind]\nsped_mps = 5\n",
    "unknown section": "version = 1\n[wnd]\nspeed_mps = 5\n",
    "wrong type": 'version = 1\n[wind]\nspeed_mps = "5"\n',
    "too large": "version = 1\n[wind]\nspeed_mps = 60.5\n",
    "too small": "version = 1\n[camera]\nfov_deg = 0.5\n",
    "unknown choice": 'version = 1\n[ocean]\nspectrum = "jonswp"\n',
    "no whole number": "version = 1\n[ocean]\ncascade_count = 2.5\n",
    "no power of two": "version = 1\n[ocean]\nsize = 100\n",
    "too many elements": "version = 1\n" + LIGHTS,
    "no list": "version = 1\n[light]\nx_m = 1\n",
    "a list": "version = 1\n[[wind]]\nspeed_mps = 1\n",
    "keyframes of a constant": "version = 1\n[wind]\nspeed_mps = { keys = [{ t = 0, value = 1 }] }\n",
    "keyframe out of range": "version = 1\n[camera]\ny_m = { keys = [{ t = 0, value = 1e6 }] }\n",
    "keyframe without a value": "version = 1\n[camera]\ny_m = { keys = [{ t = 0 }] }\n",
    "unknown interpolation": 'version = 1\n[camera]\ny_m = { keys = [{ t = 0, value = 1 }], interpolation = "cubic" }\n',
    "two numbers": "version = 1\n[[light]]\ncolour = [1, 1]\n",
    "two of which one counts": "version = 1\n[[ocean.swell]]\nperiod_s = 8\nwavelength_m = 80\n",
    "a key and its earlier name": "version = 1\n[[cloud]]\nbillboards = \"crisp\"\npuffs = \"crisp\"\n",
}  # fmt: skip
ACCEPTED = {
    "a date": "version = 1\n[sun]\ntime_utc = 2024-06-21T20:10:00Z\n",
    "an earlier name": "version = 1\n[[cloud]]\npuffs = \"crisp\"\n",
    "keyframes of three numbers": "version = 1\n[[light]]\ncolour = { keys = [{ t = 0, value = [1, 1, 1] }] }\n",
    "benchmarks": "version = 1\n[bench]\ncameras = [1]\n",
}


def as_json(value):
    """What JSON has no type for is a string there."""
    if isinstance(value, dict):
        return {key: as_json(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [as_json(inner) for inner in value]
    return value.isoformat() if isinstance(value, (datetime.date, datetime.time)) else value


def main(program, scenes):
    def output_of(*words):
        return subprocess.run([program, "scene", *words], capture_output=True, text=True, check=False)

    schema = json.loads(output_of("schema").stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults = []

    def expect(name, text, accepted):
        by_schema = [f"{list(error.path)}: {error.message[:200]}" for error in validator.iter_errors(as_json(tomllib.loads(text)))]
        if (not by_schema) != accepted:
            faults.append(f"{name}: the schema finds {by_schema}")

    shipped = sorted(pathlib.Path(scenes).glob("*.toml"))
    for scene in shipped:
        expect(scene.name, scene.read_text(encoding="utf-8"), True)
    expect("offing scene new", output_of("new").stdout, True)
    checked = output_of("check", "--quiet", *shipped)
    if checked.returncode != 0 or not shipped:
        faults.append(f"{len(shipped)} shipped scenes: offing scene check: {checked.stdout}{checked.stderr}")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.toml"
        for cases, accepted in ((BROKEN, False), (ACCEPTED, True)):
            for name, text in cases.items():
                expect(name, text, accepted)
                file.write_text(text, encoding="utf-8")
                result = output_of("check", file)
                if result.returncode != (0 if accepted else 2):
                    faults.append(f"{name}: offing scene check: exit {result.returncode}, {result.stdout}{result.stderr}")
    print(f"{len(shipped)} shipped scenes, {len(BROKEN)} broken ones, {len(ACCEPTED)} others")
    sys.exit("\n".join(faults) or None)


main(*sys.argv[1:])
