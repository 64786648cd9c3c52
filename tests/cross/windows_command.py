# SPDX-License-Identifier: Apache-2.0
"""The command for Windows, under Wine, beside the one for this machine: the same words make the same JSON.
SLAMICP names the one, SLAMICP_WINDOWS the other with what runs it."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

HERE = [os.environ["SLAMICP"]]
WINDOWS = os.environ["SLAMICP_WINDOWS"].split(" ")
# Wine takes this machine's file names for letters of its locale.
ENVIRONMENT = {**os.environ, "LC_ALL": "C.UTF-8"}


def without_times(told):
    """What JSON tells, but for how long it took."""
    if isinstance(told, dict):
        return {name: without_times(value) for name, value in told.items() if not name.endswith(("_us", "_s", "seconds"))}
    return [without_times(value) for value in told] if isinstance(told, list) else told


class WindowsCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_in(self, folder, program, *words):
        (self.folder / folder).mkdir(exist_ok=True)
        return subprocess.run([*program, *map(str, words)], cwd=self.folder / folder, capture_output=True, timeout=300,
                              env=ENVIRONMENT)

    def done(self, folder, program, *words):
        result = self.run_in(folder, program, *words)
        self.assertEqual(result.returncode, 0, result.stdout.decode() + result.stderr.decode())
        return result.stdout

    def told(self, folder, program, *words):
        return without_times(json.loads(self.done(folder, program, *words, "--json", "-")))

    def assert_same(self, here, there, tolerance, where="it"):
        """The same JSON; numbers that are no integers within the tolerance."""
        if isinstance(here, dict):
            self.assertEqual(here.keys(), there.keys(), where)
            for name in here:
                self.assert_same(here[name], there[name], tolerance, f"{where}.{name}")
        elif isinstance(here, list):
            self.assertEqual(len(here), len(there), where)
            for k, (one, other) in enumerate(zip(here, there)):
                self.assert_same(one, other, tolerance, f"{where}[{k}]")
        elif isinstance(here, float) and isinstance(there, float):
            self.assertTrue(math.isclose(here, there, rel_tol=0.0, abs_tol=tolerance), f"{where}: {here} and {there}")
        else:
            self.assertEqual(here, there, where)

    def test_demo(self):
        here = self.told("here", HERE, "demo", "--out", "demo")
        there = self.told("there", WINDOWS, "demo", "--out", "demo")
        self.assert_same(here, there, 1e-6)
        self.assertEqual(sorted(os.listdir(self.folder / "here/demo")), sorted(
            [*os.listdir(self.folder / "there/demo"),
             *(name for name in os.listdir(self.folder / "here/demo") if name.endswith(".png"))]))

    def test_localize_a_log_that_nobody_tuned_for(self):
        self.done("here", HERE, "simulate", "--seed", 4177, "--obstacle", "A3", "--out", "run.clf", "--map-out", "map.pcd",
                  "--truth", "truth.tum")
        x, y, theta = self.start("here/truth.tum")
        words = ("localize", "../here/run.clf", "--map", "../here/map.pcd", "--initial-pose", f"{x},{y},{theta}",
                 "--outlier-distance", "0.1", "--trajectory", "run.tum", "--outliers", "outliers.csv")
        here, there = self.told("here", HERE, *words), self.told("there", WINDOWS, *words)
        self.assert_same(here, there, 1e-6)
        for name in ("run.tum", "outliers.csv"):
            ours, theirs = ((self.folder / folder / name).read_bytes() for folder in ("here", "there"))
            self.assertNotIn(b"\r", theirs)
            self.assert_same_table(ours.decode(), theirs.decode())

    def assert_same_table(self, here, there):
        self.assertEqual(here.count("\n"), there.count("\n"))
        for one, other in zip(here.splitlines(), there.splitlines()):
            if one == other:
                continue
            for a, b in zip(one.replace(",", " ").split(), other.replace(",", " ").split()):
                self.assertTrue(a == b or abs(float(a) - float(b)) < 2e-6, f"{one}\n{other}")

    def start(self, name):
        words = (self.folder / name).read_text().splitlines()[0].split()
        return float(words[1]), float(words[2]), 2.0 * math.atan2(float(words[6]), float(words[7]))

    def test_names_of_any_letters_and_lines_that_end_in_two(self):
        self.done("here", HERE, "simulate", "--speed", 0.9, "--out", "run.clf", "--map-out", "map.xyz")
        folder = self.folder / "here" / "Straße Żółw 地図"
        folder.mkdir()
        for name in ("run.clf", "map.xyz"):
            text = (self.folder / "here" / name).read_bytes()
            self.assertNotIn(b"\r", text)
            (folder / name).write_bytes(text.replace(b"\n", b"\r\n"))
        out = f"{folder.name}/Karte für morgen.pcd"
        self.done("here", WINDOWS, "convert", f"{folder.name}/map.xyz", out)
        self.done("here", HERE, "convert", "map.xyz", "map.pcd")
        self.assertEqual((self.folder / "here" / out).read_bytes(), (self.folder / "here" / "map.pcd").read_bytes())
        info = [self.told("here", program, "info", name)
                for program, name in ((HERE, "run.clf"), (WINDOWS, f"{folder.name}/run.clf"))]
        self.assertEqual(info[1].pop("file", None), f"{folder.name}/run.clf")
        info[0].pop("file", None)
        self.assert_same(*info, 0.0)

    def test_says_what_is_wrong_in_the_same_words(self):
        for words in (("localize", "none.clf", "--map", "none.pcd"), ("no-such-verb",), ("demo", "--obstacle", "B9")):
            here, there = (self.run_in("here", program, *words) for program in (HERE, WINDOWS))
            self.assertEqual(here.returncode, there.returncode)
            self.assertEqual(here.stderr, there.stderr.replace(b"\r\n", b"\n"))


if __name__ == "__main__":
    unittest.main()
