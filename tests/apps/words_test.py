# SPDX-License-Identifier: Apache-2.0
"""Words on the command line: help, exit status, --config, --json, messages."""
import json
import unittest

from command import CommandTest, VERBS

SHARED = ("--method", "--max-correspondence-distance", "--outlier-distance", "--max-iterations", "--max-range",
          "--laser-offset", "--scan-topic", "--odometry-topic", "--base-frame", "--threads", "--config")
# What docs and scripts may rely on (cli.md).
OPTIONS = {
    "demo": ("--out",),
    "info": ("FILE", "--scan-topic", "--odometry-topic", "--base-frame"),
    "convert": ("IN", "OUT", "--resolution", "--scan-topic"),
    "simulate": ("--out", "--world", "--route", "--obstacle", "--people", "--layout", "--lidar", "--robot", "--speed",
                 "--seed", "--truth", "--map-out", "--picture"),
    "map": ("LOG", "--out", "--resolution", "--trajectory", "--picture") + SHARED,
    "localize": ("LOG", "--map", "--initial-pose", "--trajectory", "--outliers", "--obstacles", "--metrics",
                 "--update-map", "--proposals", "--obstacle-distance", "--report") + SHARED,
    "align": ("SOURCE", "TARGET", "--method", "--initial-pose", "--voxel", "--transform", "--outliers", "--merged"),
    "odometry": ("LOG", "--trajectory", "--picture", "--reference", "--map-radius", "--wheels", "--no-deskew",
                 "--method", "--max-correspondence-distance", "--scan-topic", "--config"),
    "experiment": ("NAME", "--out", "--seed", "--runs", "--speeds", "--obstacles", "--every", "--no-times"),
    "evaluate": ("TRAJECTORY", "--truth", "--align", "--relations", "--relative-distance"),
    "experiment": ("NAME", "--out", "--seed", "--runs", "--speeds", "--obstacles", "--every", "--no-times"),
}


class Help(CommandTest):
    def test_help_of_every_verb_names_every_option_and_an_example(self):
        for verb in VERBS:
            with self.subTest(verb=verb):
                text = self.done("help", verb).stdout
                self.assertEqual(text, self.done(verb, "--help").stdout)
                self.assertIn(f"Usage: slamicp {verb} [OPTIONS]", text)
                for option in OPTIONS[verb] + ("--json",):
                    self.assertIn(f"  {option} ", text.replace("\n", " \n"))
                self.assertIn(f"Example: slamicp {verb}", text)

    def test_units_stand_beside_lengths(self):
        text = self.done("help", "localize").stdout
        self.assertIn("[m]", text)
        self.assertIn("--max-correspondence-distance FLOAT:POSITIVE=0.3", text)

    def test_help_lists_the_verbs_and_version_is_told(self):
        for words in (("--help",), ("help",)):
            text = self.done(*words).stdout
            for verb in VERBS:
                self.assertIn(verb, text)
        self.assertRegex(self.done("--version").stdout, r"^slamicp \d+\.\d+\.\d+\n$")


class WrongWords(CommandTest):
    def test_exit_with_2(self):
        for words in ((), ("nonsense",), ("help", "nonsense"), ("localize",), ("map", "run.clf"),
                      ("localize", "run.clf"), ("info",), ("align", "a.csv"), ("simulate",), ("evaluate", "run.tum"),
                      ("info", "a.csv", "b.csv"), ("info", "a.csv", "--nonsense"),
                      ("simulate", "--out", "run.clf", "--speed", "fast"),
                      ("simulate", "--out", "run.clf", "--speed", "-1"),
                      ("localize", "run.clf", "--map", "map.csv", "--initial-pose", "1,2"),
                      ("localize", "run.clf", "--map", "map.csv", "--method", "nonsense"),
                      ("localize", "run.clf", "--map", "map.csv", "--threads", "0"),
                      ("evaluate", "run.tum", "--truth", "t.tum", "--align", "nonsense"),
                      ("evaluate", "run.tum", "--truth", "t.tum", "--relations", "r"),
                      ("localize", "run.clf", "--map", "map.csv", "--config", "missing.yaml")):
            with self.subTest(words=words):
                result = self.wrong_words(*words)
                self.assertNotEqual(result.stderr, "")


class MissingFiles(CommandTest):
    def test_exit_with_1_say_what_where_and_how_to_mend_and_leave_nothing(self):
        self.write("map.csv", "0,0\n1,0\n1,1\n")
        self.write("run.tum", "0 0 0 0 0 0 0 1\n")
        for words in (("info", "none.clf"), ("info", "none.csv"), ("info", "none.pcd"),
                      ("convert", "none.pcd", "out.ply"), ("convert", "none.clf", "out.csv"),
                      ("map", "none.clf", "--out", "out.csv", "--trajectory", "out.tum"),
                      ("localize", "none.clf", "--map", "map.csv", "--trajectory", "out.tum"),
                      ("align", "none.csv", "map.csv", "--transform", "out.txt"),
                      ("align", "map.csv", "none.csv", "--transform", "out.txt"),
                      ("evaluate", "none.tum", "--truth", "run.tum"), ("evaluate", "run.tum", "--truth", "none.tum"),
                      ("evaluate", "run.tum", "--relations", "none.relations")):
            with self.subTest(words=words):
                self.could_not(*words, "--json", "out.json", says=("none.", "cannot be read", "; "))
                self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["map.csv", "run.tum"])

    def test_broken_files_are_named_with_their_line(self):
        self.write("broken.csv", "0,0\n1,abc\n")
        self.could_not("info", "broken.csv", says=("broken.csv:2",))
        self.write("broken.clf", "FLASER 2 1.0 1.0 0 0 0 0 0 0 1.0 host 1.0\nFLASER 3 1.0 x\nFLASER 1 1\n")
        self.could_not("info", "broken.clf", says=("broken.clf:2",))
        self.write("broken.tum", "0 0 0 0 0 0 0 1\n1 0 0 0\n")
        self.could_not("evaluate", "broken.tum", "--truth", "broken.tum", says=("broken.tum:2",))

    def test_unknown_endings_and_worlds_are_refused(self):
        self.write("thing.abc", "1 2\n")
        self.could_not("info", "thing.abc", says=(".abc",))
        self.could_not("simulate", "--out", "run.abc", says=(".abc",))
        self.could_not("simulate", "--out", "run.clf", "--world", "moon", says=("moon",))
        self.could_not("simulate", "--out", "run.clf", "--obstacle", "Q9", says=("Q9",))
        self.assertEqual([path.name for path in self.folder.iterdir()], ["thing.abc"])


class Config(CommandTest):
    def setUp(self):
        super().setUp()
        self.done("simulate", "--out", "run.clf", "--speed", "20", "--map-out", "map.csv")

    def localize(self, *words):
        return ("localize", "run.clf", "--map", "map.csv", "--initial-pose", "5.9,-4.2,1.566", *words)

    def test_gives_options_and_the_command_line_goes_before(self):
        self.write("options.yaml", "json: from_file.json\nmax-iterations: 1\nmethod: point-to-point\n")
        self.done(*self.localize("--config", "options.yaml"))
        self.assertLessEqual(json.loads(self.read("from_file.json"))["iterations_mean"], 1.0)
        both = self.summary(*self.localize("--config", "options.yaml", "--max-iterations", "50"))
        self.assertGreater(both["iterations_mean"], 1.0)

    def test_gives_lists_to_options_that_may_come_more_than_once(self):
        self.write("options.yaml", "scan-topic: [/a, /b]\n")
        self.done(*self.localize("--config", "options.yaml"))  # of no meaning for a log that is no ROS log

    def test_refuses_unknown_names_and_bad_values_with_file_and_line(self):
        for line, says in (("nonsense: 1", "nonsense"), ("max-range: abc", "max-range"), ("threads: 0", "threads"),
                           ("method: nonsense", "nonsense"), ("max-range: [1, 2]", "max-range")):
            with self.subTest(line=line):
                self.write("options.yaml", f"# a comment\nmin-range: 0.1\n{line}\n")
                self.could_not(*self.localize("--config", "options.yaml", "--trajectory", "out.tum"),
                               says=("options.yaml:3", says))
                self.assertFalse((self.folder / "out.tum").exists())

    def test_refuses_what_is_no_yaml(self):
        self.write("options.yaml", "a: [1\n")
        self.could_not(*self.localize("--config", "options.yaml"), says=("options.yaml:",))


if __name__ == "__main__":
    unittest.main()
