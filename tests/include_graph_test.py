#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A made-up project for each rule of include_graph.py: the faultless one passes, every breach is found."""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from include_graph import Checker  # noqa: E402

FAULTLESS = {
    "src/CMakeLists.txt": "set(SLAMICP_CORE_ROOMS\n  geometry\n  scan\n  search\n  map)\n",
    "include/slamicp/error.hpp": "#include <string>\n",
    "include/slamicp/geometry/pose.hpp": "#include <Eigen/Core>\n#include <slamicp/error.hpp>\n",
    "include/slamicp/scan/scan.hpp": "#include <map>\n#include <slamicp/geometry/pose.hpp>\n",
    "include/slamicp/io/log.hpp": "#include <slamicp/scan/scan.hpp>\n#include <fstream>\n",
    "src/geometry/pose.cpp": '#include <cstdio>\n// printf("x");\nint f() { return std::snprintf(0, 0, "std::cout"); }\n',
    "src/scan/private.hpp": "#pragma once\n",
    "src/search/parallel.hpp": "#include <thread>\n",
    "src/scan/scan.cpp": '#include "scan/private.hpp"\n#include <slamicp/scan/scan.hpp>\n',
    "src/io/log.cpp": "#include <cairo.h>\n#include <iostream>\nvoid f() { std::cout << 1; }\n",
}


class IncludeGraph(unittest.TestCase):
    def faults(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**FAULTLESS, **changes.get("files", {})}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return Checker(root).run()

    def assert_fault(self, name, text, words):
        faults = self.faults(files={name: text})
        self.assertEqual(len(faults), 1, faults)
        self.assertTrue(faults[0].startswith(name + ":"), faults)
        self.assertIn(words, faults[0])

    def test_faultless(self):
        self.assertEqual(self.faults(), [])

    def test_room_below(self):
        self.assert_fault("src/geometry/a.cpp", "#include <slamicp/scan/scan.hpp>\n", "must not include scan")
        self.assert_fault("include/slamicp/map/a.hpp", "#include <slamicp/io/log.hpp>\n", "must not include io")
        self.assert_fault("src/geometry/a.cpp", '#include "scan/private.hpp"\n', "must not include scan")
        self.assert_fault("src/a.cpp", "#include <slamicp/geometry/pose.hpp>\n", "must not include geometry")

    def test_names_the_line(self):
        self.assertIn("src/geometry/a.cpp:3:", self.faults(
            files={"src/geometry/a.cpp": "\n\n  #  include <slamicp/scan/scan.hpp>\n"})[0])

    def test_private_in_public(self):
        self.assert_fault("include/slamicp/map/a.hpp", '#include "scan/private.hpp"\n', "private")
        self.assert_fault("include/slamicp/map/a.hpp", "#include <scan/private.hpp>\n", "private")

    def test_header_that_is_not_there(self):
        self.assert_fault("src/map/a.cpp", "#include <slamicp/scan/none.hpp>\n", "no public header")
        self.assert_fault("src/map/a.cpp", '#include "none.hpp"\n', "no file of src/")

    def test_unknown_room(self):
        self.assert_fault("src/attic/a.cpp", "#include <vector>\n", "no room")

    def test_third_party_in_core(self):
        self.assert_fault("src/map/a.cpp", "#include <cairo.h>\n", "neither Eigen")
        self.assert_fault("src/map/a.cpp", "#include <nlohmann/json.hpp>\n", "neither Eigen")

    def test_clock_thread_file_print_chance(self):
        for header in ("chrono", "thread", "fstream", "iostream", "random", "future"):
            self.assert_fault("src/map/a.cpp", f"#include <{header}>\n", "no place in the core")

    def test_calls_in_core(self):
        for call in ('printf("x")', 'std::puts("x")', "std::cout << 1", "std::rand()", 'std::getenv("X")'):
            self.assert_fault("src/map/a.cpp", f"void f() {{\n  {call};\n}}\n", "src/map/a.cpp:2: the core must not use")


if __name__ == "__main__":
    unittest.main()
