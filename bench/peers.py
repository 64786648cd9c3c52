#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""small_gicp and Open3D, by their Python wheels, on the scans of slamicp-bench; one thread.

    python3 -m venv build/peers && build/peers/bin/pip install small_gicp open3d
    build/peers/bin/python bench/peers.py --map MAP.csv --ranges RANGES.csv --poses POSES.csv --json peers.json
    slamicp-bench --map MAP.csv --ranges RANGES.csv --poses POSES.csv --peers peers.json

A peer whose wheel is not there is named as missing. What is timed begins with the scan as a NumPy array and ends with
its pose and its outliers: the points that the peer's own tree finds no map point for at the final pose.
"""
import argparse
import importlib
import json
import os
import pathlib
import sys
import time

os.environ["OMP_NUM_THREADS"] = "1"  # before any wheel is loaded

GATE = 0.3
MAX_ITERATIONS = 50


def transform_of(pose):
    """x, y, theta [m, m, rad] as a 4x4 matrix."""
    x, y, theta = pose
    T = np.eye(4)
    T[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    T[:2, 3] = x, y
    return T


def flat(points):
    """2D points in space."""
    return np.column_stack([points, np.zeros(len(points))])


def line_normals(points, neighbours=10):
    """Across the direction in which each point's neighbours spread most."""
    normals = np.zeros((len(points), 3))
    for k, point in enumerate(points):
        squared = ((points - point) ** 2).sum(axis=1)
        near = points[np.argpartition(squared, neighbours)[:neighbours]]
        _, axes = np.linalg.eigh(np.cov(near.T))
        normals[k, :2] = axes[:, 0]
    return normals


class SmallGicp:
    """Its planes need a map with some height: three layers, 3 cm apart. A flat scan meets the middle one only."""

    def __init__(self, points, kind, epsilon):
        import small_gicp
        self._api = small_gicp
        layers = [flat(points) + [0.0, 0.0, z] for z in ((0.0, -0.03, 0.03) if kind == "PLANE_ICP" else (0.0,))]
        self._map = small_gicp.PointCloud(np.vstack(layers))
        self._tree = small_gicp.KdTree(self._map, num_threads=1)
        if kind == "PLANE_ICP":
            small_gicp.estimate_normals(self._map, self._tree, 20, 1)
        self._options = {"registration_type": kind, "max_correspondence_distance": GATE, "num_threads": 1,
                         "max_iterations": MAX_ITERATIONS}
        if epsilon:
            self._options |= {"rotation_epsilon": epsilon, "translation_epsilon": epsilon}

    def localize(self, scan, T_guess):
        result = self._api.align(self._map, self._api.PointCloud(scan), self._tree, T_guess, **self._options)
        T = result.T_target_source
        _, squared = self._tree.batch_nearest_neighbor_search(scan @ T[:3, :3].T + T[:3, 3], 1)
        return T, result.iterations, np.flatnonzero(np.asarray(squared) >= GATE * GATE)


class Open3D:
    """It builds its tree at every call; its pairs are those at the final pose."""

    def __init__(self, points, normals=None):
        import open3d
        self._api = open3d
        registration = open3d.pipelines.registration
        self._map = self._cloud(flat(points))
        if normals is not None:
            self._map.normals = open3d.utility.Vector3dVector(normals)
        self._step = (registration.TransformationEstimationPointToPoint() if normals is None
                      else registration.TransformationEstimationPointToPlane())
        self._stop = registration.ICPConvergenceCriteria(1e-6, 1e-6, MAX_ITERATIONS)

    def _cloud(self, points):
        return self._api.geometry.PointCloud(self._api.utility.Vector3dVector(points))

    def localize(self, scan, T_guess):
        result = self._api.pipelines.registration.registration_icp(
            self._cloud(scan), self._map, GATE, T_guess, self._step, self._stop)
        outlier = np.ones(len(scan), dtype=bool)
        outlier[np.asarray(result.correspondence_set)[:, 0]] = False
        return result.transformation, None, np.flatnonzero(outlier)


def contenders(points):
    """Name, what it is, what prepares it."""
    normals = line_normals(points)
    return [
        ("small_gicp_plane", "small_gicp PLANE_ICP, its default stop", lambda: SmallGicp(points, "PLANE_ICP", None)),
        ("small_gicp_plane_tight", "small_gicp PLANE_ICP, stop 1e-4", lambda: SmallGicp(points, "PLANE_ICP", 1e-4)),
        ("small_gicp_point", "small_gicp ICP, point to point, stop 1e-4", lambda: SmallGicp(points, "ICP", 1e-4)),
        ("open3d_plane", "Open3D ICP, point to plane with normals in the plane", lambda: Open3D(points, normals)),
        ("open3d_point", "Open3D ICP, point to point", lambda: Open3D(points)),
    ]


def load_scene(words):
    """Map, and a (scan, truth, guess) for each scan taken."""
    points = np.loadtxt(words.map, delimiter=",", ndmin=2)[:, :2]
    ranges = np.loadtxt(words.ranges, delimiter=",", ndmin=2)
    poses = np.loadtxt(words.poses, delimiter=",", skiprows=1, ndmin=2)
    if len(ranges) != len(poses) or poses.shape[1] != 6:
        raise ValueError(f"{words.poses}: {poses.shape[0]} poses of {poses.shape[1]} values, but {len(ranges)} scans in "
                         f"{words.ranges}; give a line of truth_x,truth_y,truth_th,guess_x,guess_y,guess_th a scan")
    angles = np.radians(np.linspace(-words.fov_deg / 2, words.fov_deg / 2, ranges.shape[1]))
    wanted = len(ranges) if words.scans == 0 else min(words.scans, len(ranges))
    trials = []
    for k in (number * len(ranges) // wanted for number in range(wanted)):
        seen = np.isfinite(ranges[k]) & (ranges[k] >= 0.02)
        reach = ranges[k][seen]
        scan = flat(np.column_stack([reach * np.cos(angles[seen]), reach * np.sin(angles[seen])]))
        trials.append((scan, poses[k, :3], poses[k, 3:]))
    return points, trials


def exact_outliers(points, scan, T):
    """By brute force in double."""
    in_map = scan @ T[:3, :3].T + T[:3, 3]
    return np.array([k for k, (x, y, _) in enumerate(in_map)
                     if not (((points[:, 0] - x) ** 2 + (points[:, 1] - y) ** 2) < GATE * GATE).any()], dtype=int)


def spread(values):
    return {"mean": float(np.mean(values)), "p95": float(np.quantile(values, 0.95, method="inverted_cdf")),
            "max": float(np.max(values))}


def row_of(name, what, prepare_ms, times, estimates, points, trials):
    error_m, turn_deg, exact, wrong = [], [], 0, 0
    for (T, _, outliers), (scan, truth, _) in zip(estimates, trials):
        error_m.append(float(np.hypot(*(T[:2, 3] - truth[:2]))))
        turned = np.arctan2(T[1, 0], T[0, 0]) - truth[2]
        turn_deg.append(abs(float(np.degrees(np.arctan2(np.sin(turned), np.cos(turned))))))
        differing = len(np.setxor1d(outliers, exact_outliers(points, scan, T)))
        exact += differing == 0
        wrong += differing
    iterations = [count for _, count, _ in estimates if count is not None]
    return {"name": name, "what": what, "process": "another", "samples": len(times),
            "median_us": float(np.median(times)), "p99_us": float(np.quantile(times, 0.99)), "ratio_to_ours": None,
            "prepare_ms": prepare_ms, "iterations": float(np.mean(iterations)) if iterations else None,
            "scans": len(trials), "failures": sum(m > 0.1 or deg > 1.0 for m, deg in zip(error_m, turn_deg)),
            "error_mm": spread([1e3 * m for m in error_m]), "rotation_deg": spread(turn_deg),
            "outliers_mean": float(np.mean([len(outliers) for _, _, outliers in estimates])),
            "outlier_agreement": exact / len(trials),
            "outlier_point_agreement": 1.0 - wrong / max(1, sum(len(scan) for scan, _, _ in trials))}


def race(points, trials, rounds):
    """All peers in turns, scan block by scan block."""
    ready, missing = [], []
    for name, what, prepare in contenders(points):
        wheel = "open3d" if name.startswith("open3d") else "small_gicp"
        try:
            importlib.import_module(wheel)
        except ImportError as problem:
            missing.append({"name": name, "why": str(problem), "mend": f"pip install {wheel}"})
            continue
        start = time.perf_counter()
        matcher = prepare()
        ready.append((name, what, 1e3 * (time.perf_counter() - start), matcher, [], []))
        matcher.localize(trials[0][0], transform_of(trials[0][2]))  # what it does once is not a scan's time
    block = 25
    for turn, begin in enumerate(begin for _ in range(rounds) for begin in range(0, len(trials), block)):
        for k in range(len(ready)):
            _, _, _, matcher, times, estimates = ready[(k + turn) % len(ready)]
            for scan, _, guess in trials[begin:begin + block]:
                T_guess = transform_of(guess)
                start = time.perf_counter()
                estimate = matcher.localize(scan, T_guess)
                times.append(1e6 * (time.perf_counter() - start))
                if len(estimates) < len(trials):
                    estimates.append(estimate)
    rows = [row_of(name, what, prepare_ms, times, estimates, points, trials)
            for name, what, prepare_ms, _, times, estimates in ready]
    return rows, missing


def main():
    parser = argparse.ArgumentParser(description="small_gicp and Open3D on the scans of slamicp-bench, one thread")
    parser.add_argument("--map", required=True, help="x,y a line")
    parser.add_argument("--ranges", required=True, help="ranges [m], a scan a line")
    parser.add_argument("--poses", required=True, help="truth and guess of each scan, under a header")
    parser.add_argument("--fov-deg", type=float, default=270.0, help="field of view, first beam to last")
    parser.add_argument("--scans", type=int, default=0, help="take so many scans, evenly spread; 0: all")
    parser.add_argument("--rounds", type=int, default=3, help="times through all scans")
    parser.add_argument("--json", required=True, help="where the results go, for slamicp-bench --peers")
    words = parser.parse_args()
    points, trials = load_scene(words)
    rows, missing = race(points, trials, words.rounds)
    scene = {"name": pathlib.Path(words.ranges).stem, "map": words.map, "ranges": words.ranges, "poses": words.poses,
             "fov_deg": words.fov_deg, "map_points": len(points), "scans": len(trials)}
    pathlib.Path(words.json).write_text(
        json.dumps({"scene": scene, "rounds": words.rounds, "gate": GATE, "contenders": rows, "missing": missing},
                   indent=2) + "\n")
    for row in rows:
        error = row["error_mm"]
        print(f"{row['name']:24} {row['median_us']:9.1f} us  {error['mean']:.2f} / {error['p95']:.2f} / "
              f"{error['max']:.2f} mm  {row['failures']} of {row['scans']} failed")
    for peer in missing:
        print(f"missing: {peer['name']}: {peer['why']}; {peer['mend']}")


if __name__ == "__main__":
    try:
        import numpy as np
        main()
    except (ImportError, OSError, ValueError) as problem:
        sys.exit(f"peers.py: {problem}")
