"""command_tree_test.py PROGRAM...: --print-commands has what the help of each command has."""

import re
import subprocess
import unittest

from reference_modules import PROGRAMS

import command_trees as trees

FLAG = re.compile(r"^  (-[\w-]+(?:,-[\w-]+)*)(?: (\S+)|  |$)", re.MULTILINE)  # "  -o,--output DIR (required)   ..."
NAMED = re.compile(r"^  ([\w-]+(?:, [\w-]+)*)  ", re.MULTILINE)  # below "Subcommands:"


def words(text):
    return " ".join(text.split())


class CommandTreeTest(unittest.TestCase):
#Fails if a command, an option, a placeholder or a help text is missing, or one is there that the help lacks.
    def test_tree_is_what_the_help_lists(self):
        for program, tree in zip(PROGRAMS, trees.read(PROGRAMS)):
            for command in tree["commands"]:
                with self.subTest(command["name"]):
                    path = command["name"].split(" ")[1:]
                    help_text = subprocess.run(
                        [program, *path, "--help"], check=True, capture_output=True, text=True
                    ).stdout
                    body = help_text.partition("Usage:")[2].split("\n\nExample")[0]
                    options, _, below = body.partition("\nSubcommands:\n")
                    listed = [(names, "" if value == "(required)" else value) for names, value in FLAG.findall(options)]
                    said = [(",".join(option["names"]), option["placeholder"]) for option in command["options"]]
                    self.assertEqual(sorted(listed), sorted(said))
                    inner = [
                        ", ".join([inner["name"].split(" ")[-1], *inner["other_names"]])
                        for inner in trees.inner_commands(tree, command)
                    ]
                    self.assertEqual(NAMED.findall(below.split("\n\n")[0]) if below else [], inner)
                    flat = words(help_text)
                    for option in command["options"] + command["positionals"]:
                        self.assertIn(words(option["help"]), flat)
                        self.assertIn(words(option.get("expected", "")), flat)

#Fails if a range or a choice is lost on its way from the row of the schema.
    def test_rows_are_told(self):
        tree = next(tree for tree in trees.read(PROGRAMS) if tree["program"] == "offing")
        bake = next(command for command in tree["commands"] if command["name"] == "offing ocean bake")
        options = {option["names"][-1]: option for option in bake["options"]}
        wind = options["--wind-speed-mps"]
        self.assertEqual((wind["value"], wind["unit"], wind["low"], wind["high"]), ("number", "m/s", 0.1, 60))
        self.assertEqual(wind["default"], "as in [wind]: 10; with hs_m or a measured sea, computed from height and period")
        self.assertEqual(options["--spectrum"]["choices"], ["phillips", "pm", "jonswap", "tma", "swell"])
        self.assertEqual(options["--output"]["value"], "folder")
        self.assertTrue(options["--output"]["is_required"])
        self.assertEqual(options["--spectrum-file"]["value"], "file")
        self.assertEqual(options["--json"]["value"], "none")
        self.assertEqual(bake["positionals"][0]["placeholder"], "SCENE")

#Fails if the option, which is for scripts, is taken for one of a command or stands in the help.
    def test_option_stands_alone_and_in_no_help(self):
        for program in PROGRAMS:
            help_text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
            self.assertNotIn("print-commands", help_text)
            more = subprocess.run([program, "--print-commands", "--quiet"], capture_output=True)
            self.assertEqual(more.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=["command_tree_test.py"])
