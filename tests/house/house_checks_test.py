"""Each house check passes a small sound tree and finds the fault planted in it: a blind check fails here."""

import pathlib
import tempfile
import unittest

import api_page
import code_rules
import file_limits
import hops
import include_arrows
import layout
import links
import sentences
import shared_headers
import stems
import words
from repository import Repository

SOUND = {
    "kernels/README.md": "| `ocean/advance.cl` | `host/ocean/ocean.cpp` | `tests/ocean/advance_test.cpp` |\n",
    "kernels/ocean/advance.cl": '#include "ocean/phase.clh"\n__kernel void advance(__global float *h) {}\n',
    "kernels/ocean/phase.clh": "#define PHASE 1\n",
    "kernels/shared/params.h": "#ifndef A\n#define A\ntypedef struct {\n  float depth_m;  // bool\n} Params;\n"
    'static_assert(sizeof(Params) == 4, "packed");\n#endif\n',
    "host/base/error.h": "#pragma once\n#include <string>\n",
    "host/ocean/CMakeLists.txt": "offing_library(ocean SOURCES ocean.cpp)\n",
    "host/ocean/ocean.cpp": '#include "host/base/error.h"\n#include "kernels/shared/params.h"\n'
    'const char* name = "ocean/advance.cl";\nvoid set(bool foam, int size);\n',
    "host/ocl/CMakeLists.txt": "offing_library(ocl SOURCES quirks.cpp)\n",
    "host/ocl/quirks.cpp": '#include <CL/cl.h>\nbool is_pocl() { return name == "PoCL"; }\n',
    "tests/ocean/CMakeLists.txt": "offing_test(ocean_test SOURCES advance_test.cpp)\n",
    "tests/ocean/advance_test.cpp": '#include "host/ocean/ocean.cpp"\nauto s = R"(#include "nowhere.h")";\n',
    "docs/architecture.md": hops.HEADING + "\n\n| value | name | at most | way | others |\n|---|---|---|---|---|\n"
    "| depth | `depth_m` | 2 | `kernels/shared/params.h` | |\n\n## Next\n",
    "docs/api.md": "From `examples/sea.cpp`:\n```cpp\nsea.at(1);\n```\n| `host/base` | errors |\n| `kernels/shared` | |\n",
    "examples/sea.cpp": "// Shows a sea.\nint main() {\n  sea.at(1);\n}\n",
    "examples/CMakeLists.txt": "add_executable(sea sea.cpp)\n",
    "docs/guide.md": "[index](../kernels/README.md), [web](https://example.org), `host/ocean`\n",
}


class HouseChecks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for path, text in SOUND.items():
            self.write(path, text)

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def assert_finds(self, module, path, text, fault):
        self.assertEqual(module.check(Repository(self.root)), [], "the sound tree")
        self.write(path, text)
        faults = module.check(Repository(self.root))
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(fault, faults[0])

    def test_long_sentence(self):
        page = "Short one. " + " ".join(["word"] * 31) + " e.g. here. `a b` c.\n"
        self.assert_finds(sentences, "docs/long.md", page, "docs/long.md:1: a sentence of 33 words")

    def test_long_sentence_of_a_help_text(self):
        row = "| `--a` | " + " ".join(["word"] * 31) + " |\n"
        self.assert_finds(sentences, "docs/reference/a.md", row, "docs/reference/a.md:1: a sentence of 31 words")

    def test_long_sentence_of_a_comment(self):
        comment = "/** Short one.\n *\n * " + " ".join(["word"] * 31) + ". */\nint offing_call(void);\n"
        self.assert_finds(sentences, "host/c/offing.h", comment, "host/c/offing.h:3: a sentence of 31 words")

    def test_long_sentence_of_a_docstring(self):
        docstring = 'class Sea:\n    def at(self):\n        """Short one.\n\n        ' + " ".join(["word"] * 31) + '"""\n'
        self.assert_finds(sentences, "python/offing/sea.py", docstring, "python/offing/sea.py:5: a sentence of 31 words")

    def test_lower_folder_includes_higher(self):
        self.assert_finds(
            include_arrows,
            "host/base/error.h",
            '#include "host/ocean/ocean.cpp"\n',
            "host/base/error.h:1: host/base must not include host/ocean",
        )

    def test_page_shows_code_of_no_example(self):
        self.assert_finds(api_page, "examples/sea.cpp", "int main() {\n  sea.at(2);\n}\n", "has no line, or not there: sea.at(1);")

    def test_page_lacks_a_folder(self):
        self.assert_finds(api_page, "host/sky/sun.h", "#pragma once\n", "no row for host/sky")

    def test_simulations_include_each_other(self):
        self.write("host/terrain/height.h", "")
        self.assert_finds(
            include_arrows,
            "host/ocean/ocean.cpp",
            '#include "host/terrain/height.h"\n',
            "host/ocean must not include host/terrain",
        )

    def test_kernel_includes_host(self):
        self.assert_finds(
            include_arrows,
            "kernels/ocean/phase.clh",
            '#include "../host/base/error.h"\n',
            'no file "kernels/../host/base/error.h"',
        )

    def test_opencl_header_outside_its_folder(self):
        self.assert_finds(
            include_arrows, "host/ocean/ocean.cpp", "#include <CL/cl.h>\n", "reserved for host/ocl"
        )

    def test_gpl_header_without_its_licence(self):
        self.assert_finds(include_arrows, "tests/fft/fft2d_test.cpp", "#include <fftw3.h>\n", "is GPL")

    def test_mesh_library_below_the_mesh_tools(self):
        self.assert_finds(
            include_arrows, "host/base/error.h", "#include <CGAL/Surface_mesh.h>\n", "is reserved for mesh_tools"
        )

    def test_mesh_tools_include_the_other_command_line(self):
        self.write("host/cli/bake.h", "#pragma once\n")
        self.assert_finds(
            include_arrows,
            "mesh_tools/repair.h",
            '#include "host/cli/bake.h"\n',
            "mesh_tools must not include host/cli",
        )

    def test_include_not_from_the_root(self):
        self.assert_finds(
            include_arrows, "host/ocean/ocean.cpp", '#include "error.h"\n', 'no file "error.h"'
        )

    def test_folder_without_arrow(self):
        self.assert_finds(include_arrows, "host/weather/rain.h", "", "no row for its folder")

    def test_kernel_includes_another_simulation(self):
        self.write("kernels/terrain/patch.clh", "")
        self.assert_finds(
            include_arrows,
            "kernels/ocean/phase.clh",
            '#include "terrain/patch.clh"\n',
            "kernels/ocean must not include kernels/terrain",
        )

    def test_retired_word_in_a_name(self):
        self.assert_finds(words, "host/base/error.h", "int lidCount;\n", 'retired word "lid" in lidCount')
        self.assertEqual(words.retired_in("solid clouds.crisp_puffs"), [])

    def test_retired_word_in_a_text(self):
        self.assert_finds(words, "host/base/error.h", 'auto s = "a lamp";\n', 'retired word "lamp"')

    def test_retired_word_in_a_page(self):
        self.assert_finds(words, "docs/guide.md", "Mend it.\n", 'docs/guide.md:1: retired word "mend"')

    def test_retired_word_in_a_comment(self):
        self.assert_finds(words, "host/c/offing.h", "int a; /**< of the\n * lamp */\n", 'host/c/offing.h:2: retired word "lamp"')

    def test_retired_word_in_a_docstring(self):
        self.assert_finds(words, "python/offing/sea.py", 'def at():\n    """A lamp."""\n', 'python/offing/sea.py:2: retired word "lamp"')

    def test_types_that_differ_by_a_plural(self):
        self.assert_finds(
            words, "host/base/error.h", "struct Wave {\n};\nclass Waves {\n};\n", "Wave in host/base/error.h, Waves"
        )

    def test_crowded_folder(self):
        for i in range(layout.MOST_FILES - 1):
            self.write(f"host/base/part_{i}.cpp", "")
        self.assert_finds(layout, "host/base/one_more.cpp", "", "host/base: 41 files")

    def test_headers_of_the_same_name(self):
        self.assert_finds(layout, "host/ocean/error.h", "", "headers of the same name: host/base/error.h, host/ocean")

    def test_large_file(self):
        self.assert_finds(file_limits, "docs/picture.png", "x" * 1_000_001, "1000001 bytes")

    def test_kernel_not_ascii(self):
        self.assert_finds(file_limits, "kernels/ocean/phase.clh", "// \u03c9\n", "expected ASCII")

    def test_unfinished_work(self):
        self.assert_finds(file_limits, "host/base/error.h", "// TO" "DO\n", "unfinished")

    def test_kernel_of_another_name(self):
        self.assert_finds(
            stems,
            "kernels/ocean/advance.cl",
            "__kernel void evolve(__global float *h) {}\n",
            "expected one kernel, advance; found evolve",
        )

    def test_kernel_made_from_a_skeleton(self):
        self.assert_finds(stems, "kernels/ocean/advance.cl", "#define ROW_KERNEL evolve\n", "found evolve")

    def test_kernel_that_nobody_launches(self):
        self.assert_finds(stems, "host/ocean/ocean.cpp", "", 'holds the literal "ocean/advance.cl"')

    def test_kernel_missing_from_the_index(self):
        self.assert_finds(
            stems, "kernels/README.md", "`ocean/advance.cl` `host/ocean/ocean.cpp`\n", "has no row"
        )

    def test_name_not_snake_case(self):
        self.assert_finds(stems, "host/base/WaveHeight.h", "", "snake_case")

    def test_source_that_no_build_lists(self):
        self.assert_finds(stems, "host/ocean/my_ocean.cpp", "", "no CMakeLists.txt")

    def test_foreign_exception(self):
        self.assert_finds(
            code_rules,
            "host/ocean/ocean.cpp",
            "\nthrow  std::runtime_error(x);\n",
            "ocean.cpp:2: throw offing::Error",
        )

    def test_exit_outside_main(self):
        self.assert_finds(code_rules, "host/ocean/ocean.cpp", "std::exit(1);  // exit(2)\n", "only main")

    def test_two_bools_in_a_row(self):
        self.assert_finds(
            code_rules, "host/ocean/ocean.cpp", "void set(bool foam = false,\n  bool spray);\n", "two bools"
        )

    def test_vendor_test_outside_quirks(self):
        self.assert_finds(
            code_rules, "host/ocean/ocean.cpp", 'if (name.starts_with("NVIDIA CUDA")) {}\n', "quirks"
        )

    def test_shared_member_of_another_size(self):
        self.assert_finds(
            shared_headers,
            "kernels/shared/params.h",
            SOUND["kernels/shared/params.h"].replace("float depth_m", "float3 depth_m"),
            "'float3 depth_m'",
        )

    def test_shared_struct_without_size_assertion(self):
        self.assert_finds(
            shared_headers,
            "kernels/shared/params.h",
            SOUND["kernels/shared/params.h"].replace("sizeof(Params)", "sizeof(int)"),
            "static_assert",
        )

    def test_value_in_a_file_that_the_table_lacks(self):
        self.assert_finds(
            hops, "host/base/depth.h", "double depth_x_m = 0.0;\n", "host/base/depth.h: names depth_m"
        )

    def test_value_that_has_left_a_file(self):
        table = SOUND["docs/architecture.md"].replace("params.h` |", "params.h` | `host/base/`")
        self.assert_finds(hops, "docs/architecture.md", table, "depth: host/base/ does not name depth_m")

    def test_value_in_too_many_files(self):
        table = SOUND["docs/architecture.md"].replace("| 2 |", "| 0 |")
        self.assert_finds(hops, "docs/architecture.md", table, "depth: 1 files, expected at most 0")

    def test_broken_link(self):
        self.assert_finds(
            links, "docs/guide.md", "[gone](gone.md)\n", "docs/guide.md:1: gone.md does not exist"
        )

    def test_named_file_that_is_gone(self):
        self.assert_finds(
            links, "docs/guide.md", "see `host/ocean/gone.cpp`\n", "host/ocean/gone.cpp does not"
        )


if __name__ == "__main__":
    unittest.main()
