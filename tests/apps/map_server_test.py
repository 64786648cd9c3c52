# SPDX-License-Identifier: Apache-2.0
"""Maps of ROS's map_server: what we read and write against an independent reader, PyYAML and Pillow, that follows the
documentation of ROS 1's map_server and of nav2_map_server."""
import math
import os
import random
import struct
import unittest

from command import CommandTest, data_dir

try:
    import yaml
    from PIL import Image
except ImportError:
    yaml = None

OCCUPIED, FREE, UNKNOWN = "occupied", "free", "unknown"


def plain_pixels(text):
    """P2, which Pillow 9 does not read."""
    words = " ".join(line.partition("#")[0] for line in text.splitlines()).split()
    width, height, most = map(int, words[1:4])
    levels = [(int(word), True) for word in words[4:4 + width * height]]
    return most, [levels[at:at + width] for at in range(0, width * height, width)]


def pixels(path, mode):
    """The brightest level; and of each row from the top the pixels' levels, and whether each is opaque."""
    with open(path, "rb") as file:
        content = file.read()
    if content.startswith(b"P2"):
        return plain_pixels(content.decode())
    image = Image.open(path)
    most = 255
    if image.mode.startswith("I"):  # 16 bit
        most = 65535
        bands = [list(image.getdata())]
    else:
        if image.mode == "P":
            image = image.convert("RGBA" if "transparency" in image.info else "RGB")
        if image.mode == "LA":
            image = image.convert("RGBA")
        if image.mode == "1":
            image = image.convert("L")
        bands = [list(band.getdata()) for band in image.split()]
    alpha = bands.pop() if len(bands) == 4 else None
    if alpha and mode == "trinary":
        bands.append(alpha)
    width, height = image.size
    sums = [sum(values) for values in zip(*bands)]
    most *= len(bands)
    opaque = [a == 255 for a in alpha] if alpha else [True] * len(sums)
    rows = range(0, width * height, width)
    return most, [list(zip(sums[at:at + width], opaque[at:at + width])) for at in rows]


def states(yaml_path):
    """The state of each cell, row by row from the top, as both servers' documentation has it."""
    with open(yaml_path) as file:
        header = yaml.safe_load(file)
    mode = header.get("mode", "trinary")
    most, rows = pixels(os.path.join(os.path.dirname(yaml_path), header["image"]), mode)

    def state(level, opaque):
        p = (level if header["negate"] else most - level) / most
        if mode == "raw":
            per_cent = round(255 * level / most)
            if per_cent > 100:
                return UNKNOWN
            p = per_cent / 100
        elif mode == "scale" and not opaque:
            return UNKNOWN
        return OCCUPIED if p > header["occupied_thresh"] else FREE if p < header["free_thresh"] else UNKNOWN

    return [[state(*pixel) for pixel in row] for row in rows]


def counts(cells):
    return {name: sum(row.count(name) for row in cells) for name in (OCCUPIED, FREE, UNKNOWN)}


class MapServer(CommandTest):
    def setUp(self):
        if yaml is None:
            if os.environ.get("CI") == "true":
                self.fail("install python3-yaml and python3-pil")
            self.skipTest("no PyYAML and Pillow here: install python3-yaml and python3-pil")
        super().setUp()

    def header(self, image, more=""):
        self.write("map.yaml", f"image: {image}\nresolution: 0.05\norigin: [-1, 2.5, 0.1]\n{more}")
        return self.folder / "map.yaml"

    def told_counts(self, name):
        told = self.summary("info", name)
        self.assertEqual(told["kind"], "map")
        return {state: told[state] for state in (OCCUPIED, FREE, UNKNOWN)}

    def check(self, path):
        """Cell by cell: what we make of a map, and what the independent reader makes of it."""
        expected = states(path)
        self.assertEqual(self.told_counts(path), counts(expected))
        self.done("convert", path, "again.yaml")
        self.assertEqual(states(self.folder / "again.yaml"), expected)
        grey = {OCCUPIED: 0, FREE: 254, UNKNOWN: 205}
        _, rows = pixels(self.folder / "again.pgm", "trinary")
        self.assertEqual([[level for level, _ in row] for row in rows],
                         [[grey[cell] for cell in row] for row in expected])

    def random_image(self, draw, kind):
        width, height = draw.randint(1, 30), draw.randint(1, 30)
        size = width * height
        if kind == "P2":
            most = draw.choice((1, 100, 255, 65535))
            levels = " ".join(str(draw.randint(0, most)) for _ in range(size))
            self.write("map.pgm", f"P2 # a comment\n{width} {height}\n{most}\n{levels}\n")
            return "map.pgm"
        if kind == "P5 16":
            with open(self.folder / "map.pgm", "wb") as file:
                file.write(f"P5 {width} {height} 65535\n".encode())
                file.write(struct.pack(f">{size}H", *(draw.randint(0, 65535) for _ in range(size))))
            return "map.pgm"
        mode, ending = kind.split()
        image = Image.new(mode, (width, height))
        if mode == "P":
            image.putpalette([draw.randint(0, 255) for _ in range(768)])
        bands = len(image.getbands())
        level = (lambda: draw.choice((0, 50, 51, 89, 90, 204, 205, 206, 254, 255, draw.randint(0, 255))))
        image.putdata([level() if bands == 1 else tuple(level() for _ in range(bands)) for _ in range(size)])
        name = f"map.{ending}"
        image.save(self.folder / name)
        return name

    def test_every_image_and_mode_is_read_as_documented(self):
        draw = random.Random(7)
        kinds = ["L pgm", "P2", "P5 16"]
        if self.reads_png():
            kinds += ["L png", "RGB png", "RGBA png", "P png", "LA png", "1 png"]
        for round_number in range(60):
            kind = kinds[round_number % len(kinds)]
            mode = draw.choice(("trinary", "scale", "raw", None))
            low, high = sorted(draw.sample((0.0, 0.1, 0.196, 0.2, 0.25, 0.4, 0.65, 0.8, 1.0), 2))
            more = (f"negate: {draw.choice((0, 1))}\noccupied_thresh: {high}\nfree_thresh: {low}\n"
                    + (f"mode: {mode}\n" if mode else ""))
            with self.subTest(kind=kind, more=more):
                self.check(self.header(self.random_image(draw, kind), more))

    def reads_png(self):
        Image.new("L", (1, 1)).save(self.folder / "probe.png")
        self.header("probe.png", "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        return "libpng" not in self.run_command("info", "map.yaml").stderr

    def test_real_maps_are_read_as_documented(self):
        data = data_dir()
        if data is None:
            return
        names = ["mac_1st_floor_final", "willow-2010-02-18-0.10", "levinelobby"]
        for name in names + (["stata_basement"] if self.reads_png() else []):
            path = data / "maps_localization" / f"{name}.yaml"
            if path.exists():
                with self.subTest(name=name):
                    self.check(path)

    def test_a_map_made_of_a_log_is_whole_and_good_to_localize_in(self):
        self.done("simulate", "--out", "run.clf", "--speed", "2", "--truth", "true.tum")
        told = self.summary("map", "run.clf", "--out", "map.yaml", "--trajectory", "mapped.tum", "--resolution", "0.05")
        header = yaml.safe_load(self.read("map.yaml"))
        self.assertEqual(header["image"], "map.pgm")
        self.assertEqual(header["resolution"], 0.05)
        self.assertEqual((header["occupied_thresh"], header["free_thresh"]), (0.65, 0.196))
        cells = states(self.folder / "map.yaml")
        self.assertEqual(told["cells"], counts(cells))
        self.assertEqual(self.told_counts("map.yaml"), counts(cells))
        for state, least in ((OCCUPIED, 500), (FREE, 10000), (UNKNOWN, 1000)):
            self.assertGreater(counts(cells)[state], least, state)
        # Where the robot went is free.
        for _, x, y, _ in self.trajectory("mapped.tum"):
            column = math.floor((x - header["origin"][0]) / 0.05)
            row = math.floor((y - header["origin"][1]) / 0.05)
            self.assertEqual(cells[len(cells) - 1 - row][column], FREE)
        found = self.summary("localize", "run.clf", "--map", "map.yaml", "--initial-pose", "0,0,0", "--trajectory",
                             "found.tum")
        self.assertNotIn("no_overlap", found["stops"])
        apart = self.summary("evaluate", "found.tum", "--truth", "mapped.tum")["absolute"]
        self.assertLess(apart["translation"]["mean"], 0.02)

    def test_points_become_cells_and_back(self):
        draw = random.Random(3)
        points = [(draw.uniform(-3, 3), draw.uniform(-2, 2)) for _ in range(300)]
        self.write("map.csv", "".join(f"{x},{y}\n" for x, y in points))
        self.done("convert", "map.csv", "map.yaml", "--resolution", "0.02")
        told = self.told_counts("map.yaml")
        self.assertEqual(told, counts(states(self.folder / "map.yaml")))
        self.assertEqual(told[FREE], 0)
        self.done("convert", "map.yaml", "back.csv")
        back = self.numbers("back.csv")
        self.assertEqual(len(back), told[OCCUPIED])
        for x, y in points:
            self.assertLessEqual(min(max(abs(x - bx), abs(y - by)) for bx, by in back), 0.01 + 1e-9)

    def test_what_is_wrong_is_told(self):
        self.write("map.pgm", "P2 1 1 255 0\n")
        self.could_not("info", "map.pgm", says=("image of a map", "yaml"))
        more = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
        self.header("none.pgm", more)
        self.could_not("localize", "none.clf", "--map", "map.yaml", says=("none.clf",))
        self.could_not("info", "map.yaml", says=("none.pgm is not there", "map.yaml"))
        self.header("map.pgm", "negate: 0\noccupied_thresh: 0.65\n")
        self.could_not("info", "map.yaml", says=("'free_thresh'", "map.yaml"))
        self.header("map.pgm", more)
        self.could_not("convert", "map.yaml", "map.clf", says=("no scans",))
        self.wrong_words("convert", "map.yaml", "map.csv", "--resolution", "0")
        told = self.summary("info", "map.yaml")
        self.assertEqual(len(told["problems"]), 1)
        self.assertIn("turned by 5.73 deg", told["problems"][0])


if __name__ == "__main__":
    unittest.main()
