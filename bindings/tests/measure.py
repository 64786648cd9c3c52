# SPDX-License-Identifier: Apache-2.0
"""measure.py LIBRARY REFERENCE OCTAVE_FOLDER [--rounds N]: what a call costs from Python and Octave, in turns with C++."""

import argparse
import ctypes
import os
import pathlib
import statistics
import subprocess
import time

import numpy as np
import slamicp


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("library")
    parser.add_argument("reference", type=pathlib.Path)
    parser.add_argument("octave")
    parser.add_argument("--rounds", type=int, default=600)
    parser.add_argument("--octave-rounds", type=int, default=5)
    return parser.parse_args()


class InCpp:
    """The same calls, timed inside."""

    def __init__(self, library, map_points, ranges, angle_min, angle_increment, pose):
        self.library = ctypes.CDLL(library)
        doubles, floats = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_float)
        self.library.prepare.restype = ctypes.c_void_p
        for name in ("time_update", "time_align", "time_original_agent"):
            getattr(self.library, name).restype = ctypes.c_double
        self.scene = ctypes.c_void_p(
            self.library.prepare(
                map_points.ctypes.data_as(doubles),
                ctypes.c_size_t(len(map_points)),
                ranges.ctypes.data_as(floats),
                ctypes.c_size_t(len(ranges)),
                ctypes.c_double(angle_min),
                ctypes.c_double(angle_increment),
                pose.ctypes.data_as(doubles),
            )
        )

    def __getattr__(self, name):
        call = getattr(self.library, name)
        return lambda *rest: call(self.scene, *rest)


def each(times, work):
    start = time.perf_counter()
    for _ in range(times):
        work()
    return (time.perf_counter() - start) / times


def told(name, seconds, than=None):
    median, quick = statistics.median(seconds), min(seconds)
    line = f"{name:46s} {1e6 * median:10.1f} us median, {1e6 * quick:10.1f} us quickest"
    if than is not None:
        more = [ours - theirs for ours, theirs in zip(seconds, than)]
        line += f"; over C++ {1e6 * statistics.median(more):.1f} us median, {1e6 * (quick - min(than)):.1f} us quickest"
    print(line)


def main():
    args = arguments()
    map_points = np.fromfile(args.reference / "map.f64").reshape(-1, 2)
    angle_min, angle_increment = np.fromfile(args.reference / "angles.f64")[:2]
    ranges = np.fromfile(args.reference / "ranges.f32", np.float32)[:1081].copy()
    pose = np.fromfile(args.reference / "start.f64") + (0.02, 0.02, 0.01)
    cpp = InCpp(args.library, map_points, ranges, angle_min, angle_increment, pose)
    scan = slamicp.LaserScan(ranges, angle_min, angle_increment)
    points = scan.points()
    corridor = slamicp.Map(map_points)
    localizer, icp = slamicp.Localizer(corridor), slamicp.Icp()

    def update():
        localizer.set_pose(pose)
        return localizer.update(scan)

    def whole_update():
        localizer.set_pose(pose)
        return localizer.update(slamicp.LaserScan(ranges, angle_min, angle_increment)).pose

    def align():
        return icp.align(corridor, points, pose)

    print(f"{len(points)} points against {len(map_points)}; each round each in turn, {args.rounds} rounds")
    times = 10  # short turns: what the neighbours do then hits both sides
    rows = {
        "C++, Localizer set_pose + update": lambda: cpp.time_update(times, 0),
        "C++, the same, the Fix copied": lambda: cpp.time_update(times, 1),
        "Python, Localizer set_pose + update": lambda: each(times, update),
        "Python, LaserScan made, pose read": lambda: each(times, whole_update),
        "C++, Icp align with outliers": lambda: cpp.time_align(times),
        "Python, Icp align with outliers": lambda: each(times, align),
    }
    for row in rows.values():
        row()
    taken = {name: [] for name in rows}
    for _ in range(args.rounds):
        for name, row in rows.items():
            taken[name].append(row())
    for name, seconds in taken.items():
        than = None
        if name.startswith("Python"):
            than = taken[[other for other in rows if other.startswith("C++")][2 if "Icp" in name else 0]]
        told(name, seconds, than)

    if args.octave_rounds == 0:
        return
    print(f"\nOctave beside the paper's original agent (Figure 9a), in turns, {args.octave_rounds} rounds")
    rounds = []
    for _ in range(args.octave_rounds):
        done = subprocess.run(
            ["octave-cli", "-qf", "--no-history", "--path", args.octave, str(pathlib.Path(__file__).parent / "measure_octave.m")],
            capture_output=True,
            text=True,
            check=True,
            env=dict(os.environ, SLAMICP_REFERENCE=str(args.reference)),
        )
        rounds.append([float(word) for word in done.stdout.split()] + [cpp.time_original_agent(5, 1), cpp.time_original_agent(5, 0)])
    columns = list(zip(*rounds))
    original = statistics.median(columns[3])
    names = (
        "Octave, SLAMICP(M, ...): index rebuilt",
        "Octave, SLAMICP(map, ...): by handle",
        "Octave, slamicp.Localizer set_pose + update",
        "original agent, index rebuilt, brute force",
        "original agent, index kept, brute force",
    )
    for name, column in zip(names, columns):
        median = statistics.median(column)
        print(f"{name:46s} {1e3 * median:10.3f} ms median, the original agent takes x {original / median:.1f}")


if __name__ == "__main__":
    main()
