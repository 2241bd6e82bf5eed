"""installed_files_test.py BUILD PREFIX: what is installed is whole, `./dev demo` builds all of it, and an incomplete
build installs nothing."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD, PREFIX = (pathlib.Path(argument) for argument in sys.argv[1:3])
SCRIPT = BUILD / "host/install/cmake_install.cmake"


def ninja(*arguments):
    return subprocess.run(
        ["ninja", "-C", BUILD, *arguments], check=True, capture_output=True, text=True
    ).stdout.splitlines()


class InstalledFilesTest(unittest.TestCase):
    # Fails if a program or a licence has no install rule, or a program does not start from there.
    def test_programs_and_licences_are_there(self):
        for program in ("offing", "offing-view", "offing-mesh"):
            said = subprocess.run([PREFIX / "bin" / program, "--version"], capture_output=True, text=True)
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertIn("0.1.0", said.stdout)
        licences = [path.name for path in (PREFIX / "share/doc/Offing").rglob("*") if path.is_file()]
        expected = ["LICENSE"] + [path.name for path in (ROOT / "LICENSES").iterdir()]
        self.assertEqual(sorted(licences), sorted(expected))

    # Fails if a manual page or a completion has no install rule, or lies where nobody looks.
    def test_manual_pages_and_completions_are_there(self):
        for name in (
            "man/man1/offing.1",
            "man/man1/offing-ocean-bake.1",
            "man/man1/offing-view.1",
            "man/man1/offing-mesh-repair.1",
            "bash-completion/completions/offing-view",
            "zsh/site-functions/_offing-mesh",
            "fish/vendor_completions.d/offing.fish",
        ):
            self.assertTrue((PREFIX / "share" / name).is_file(), name)

    # Fails if an installed program does not find an installed scene, or the spectra it reads, by the scene's name;
    # or prefers it to a file that the user has.
    def test_programs_find_installed_scenes(self):
        def run(*arguments):
            program, *rest = arguments
            return subprocess.run([PREFIX / "bin" / program, *rest], capture_output=True, text=True, cwd=folder)

        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            for command in (
                ("offing", "ocean", "query", "buoy.toml", "--at", "0,0", "--size", "32"),
                ("offing", "clouds", "info", "cumulus.toml"),
                ("offing-view", "sphere.toml", "--headless", "--size", "64x36", "-o", "sphere.png"),
            ):
                said = run(*command)
                self.assertEqual(said.returncode, 0, said.stderr)
            self.assertEqual([path.name for path in here.iterdir()], ["sphere.png"])

            said = run("offing", "ocean", "stats", "./buoy.toml")
            self.assertEqual(said.returncode, 2)
            self.assertIn("error: ./buoy.toml: cannot open scene", said.stderr)
            (here / "buoy.toml").write_text("version = 1\n[ocean]\nmine = 1\n")
            said = run("offing", "ocean", "stats", "buoy.toml")
            self.assertEqual(said.returncode, 2)
            self.assertIn("error: buoy.toml:3:1: ocean.mine", said.stderr)

    # Fails if starting a program, or linking the library, loads what only some files need.
    def test_large_libraries_are_in_modules_alone(self):
        def needed(file):
            said = subprocess.run(["readelf", "--dynamic", "--wide", file], check=True, capture_output=True, text=True)
            return " ".join(re.findall(r"\(NEEDED\).*\[(.*)\]", said.stdout))

        (library,) = PREFIX.glob("lib/**/liboffing.so.1")
        for file in (*(PREFIX / "bin" / name for name in ("offing", "offing-view", "offing-mesh")), library):
            for name in ("gdal", "openvdb", "netcdf", "tbb"):
                self.assertNotIn(name, needed(file), file)
        modules = {path.stem: needed(path) for path in (library.parent / "offing").glob("*.so")}
        self.assertEqual(sorted(modules), ["cairo", "gdal", "netcdf", "openvdb", "present"])
        for name in ("cairo", "gdal", "netcdf", "openvdb"):
            self.assertIn(name, modules[name])
        # What a find_package() of the sea alone looks for.
        config = next(PREFIX.glob("lib/**/OffingConfig.cmake")).read_text()
        self.assertNotRegex(config, "GDAL|OpenVDB|NETCDF|CAIRO|TBB")

    # Fails if `cmake --install` after `./dev demo` misses a file: the demo builds less than is installed.
    def test_demo_builds_what_is_installed(self):
        demo = re.search(r"^run_demo\(\) \{\n.*?^\}", (ROOT / "dev").read_text(), re.M | re.S)[0]
        targets = re.search(r"build_targets ([^#\n]*)", demo)[1].split()
        built = {BUILD / word for command in ninja("-t", "commands", *targets) for word in command.split()}
        outputs = {BUILD / line.rsplit(":", 1)[0] for line in ninja("-t", "targets", "all")}
        installed = {pathlib.Path(name) for name in re.findall(r'"(/[^";\n]+)"', SCRIPT.read_text())} & outputs
        self.assertGreater(len(installed), 20)
        self.assertEqual(sorted(installed - built), [])

    # Fails if an incomplete build is installed in part, or the hint does not say what to build.
    def test_incomplete_build_installs_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "install.cmake"
            script.write_text(SCRIPT.read_text().replace("liboffing_c.a", "liboffing_gone.a"))
            prefix = pathlib.Path(folder) / "prefix"
            said = subprocess.run(
                ["cmake", f"-DCMAKE_INSTALL_PREFIX={prefix}", "-P", script], capture_output=True, text=True
            )
            self.assertNotEqual(said.returncode, 0)
            self.assertIn("liboffing_gone.a: is not built yet", said.stderr)
            self.assertIn(f"hint: cmake --build '{BUILD}' --target offing_installed", said.stderr)
            self.assertFalse(prefix.exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
