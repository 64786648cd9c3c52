# SPDX-License-Identifier: Apache-2.0
"""Malformed calls: each is refused with an error that says which kind of wrong it is, none crashes, none leaks."""

import itertools
import resource

import numpy as np
import pytest
import slamicp

NAN, INF = float("nan"), float("inf")


class Anything:
    pass


def sparse():
    """What scipy.sparse is to us: no array, however much it looks like one."""
    thing = Anything()
    thing.shape, thing.dtype, thing.nnz = (5, 2), np.dtype(float), 3
    return thing


def bad_points():
    """No array of floats of the shape (K, 2) or (K, 3) with a finite point that is within 10^6 m."""
    good = np.zeros((5, 2))
    yield from (None, 1, 1.5, "points", b"points", [], [[0.0, 1.0]], {}, Anything(), sparse(), slamicp, iter(()))
    yield from (good.astype(kind) for kind in ("i4", "u1", "i8", "?", "c8", "c16", "O", "S3", "U3", "M8[s]"))
    yield from (np.zeros(shape) for shape in ((), (5,), (2, 5), (5, 1), (5, 4), (5, 2, 1), (1, 5, 2)))
    yield from (np.array(good, dtype=[("x", "f8")]), np.ma.masked_array(good, True).astype(int))
    for value in (NAN, INF, -INF, 1e300, -1e7):
        yield np.full((5, 2), value)
    yield np.full((5, 3), NAN)


def bad_numbers(zero=True):
    yield from (NAN, INF, -INF, -1.0)
    if zero:
        yield 0.0
    yield from ("0.3", None, [], 1j, Anything(), np.zeros(3))


def bad_poses():
    yield from ((), (1.0,), (1.0, 2.0), (1.0,) * 4, "abc", 3.0, {"x": 1.0}, (1.0, "y", 2.0), np.zeros(2), np.zeros((3, 3)))
    for place, value in itertools.product(range(3), (NAN, INF, 1e300)):
        pose = [0.0, 0.0, 0.0]
        pose[place] = value
        yield pose


def calls():
    points = np.random.default_rng(1).uniform(-2.0, 2.0, (300, 2))
    good_map = slamicp.Map(points)
    in_space = slamicp.Map(np.random.default_rng(2).uniform(-2.0, 2.0, (300, 3)))
    without_lines = slamicp.Map(points, neighbours=0)
    icp = slamicp.Icp()
    localizer = slamicp.Localizer(good_map)
    ranges = np.ones(90, np.float32)
    scan = slamicp.LaserScan(ranges, 0.0, 0.05)
    fix = localizer.update(scan)

    for bad in bad_points():
        yield lambda bad=bad: slamicp.Map(bad)
        yield lambda bad=bad: slamicp.align(points, bad)
        if not (isinstance(bad, np.ndarray) and bad.dtype == float and not np.isfinite(bad).any()):
            yield lambda bad=bad: slamicp.align(bad, points)  # a scan of which nothing came back is no error
            yield lambda bad=bad: icp.align(good_map, bad)
            yield lambda bad=bad: good_map.with_added(bad)
            yield lambda bad=bad: good_map.nearest(bad, 0.3)
    yield lambda: slamicp.Map(np.zeros((0, 2)))
    yield lambda: slamicp.align(points, np.zeros((0, 2)))
    yield lambda: slamicp.align(points, np.zeros((9, 3)))
    yield lambda: icp.align(in_space, points)
    yield lambda: icp.align(without_lines, points)
    yield lambda: icp.align(None, points)
    yield lambda: in_space.with_removed([0])
    yield lambda: good_map.with_removed([300])
    yield lambda: good_map.with_removed([-1])
    yield lambda: good_map.with_removed(["a"])

    for bad in bad_numbers():
        yield lambda bad=bad: slamicp.align(points, points, max_correspondence_distance=bad)
        yield lambda bad=bad: slamicp.Icp(kernel_scale=bad)
        yield lambda bad=bad: slamicp.Icp(translation_tolerance=bad)
        yield lambda bad=bad: slamicp.Map(points, radius=bad)
        yield lambda bad=bad: slamicp.Map(points, cell=bad)
        yield lambda bad=bad: slamicp.Map(points, reach=bad)
        yield lambda bad=bad: good_map.nearest(points, bad)
        yield lambda bad=bad: slamicp.Localizer(good_map, max_correspondence_distance=bad)
        yield lambda bad=bad: slamicp.simulate_drive(slamicp.corridor_world(), "reference", speed=bad)
        if bad is not None:
            yield lambda bad=bad: slamicp.align(points, points, outlier_distance=bad)
            yield lambda bad=bad: slamicp.Localizer(good_map, outlier_distance=bad)
    for bad in (0, -1, 2**31, 1.5, "many", None, NAN):
        yield lambda bad=bad: slamicp.align(points, points, max_iterations=bad)
        yield lambda bad=bad: slamicp.Localizer(good_map, max_iterations=bad)
        yield lambda bad=bad: localizer.recover(bad)
    for bad in ("", "point", "POINT_TO_LINE", 1, None, b"point_to_line"):
        yield lambda bad=bad: slamicp.align(points, points, method=bad)
        yield lambda bad=bad: slamicp.Icp(kernel=bad)
    for bad in bad_poses():
        yield lambda bad=bad: slamicp.align(points, points, bad)
        yield lambda bad=bad: icp.align(good_map, points, bad)
        yield lambda bad=bad: localizer.set_pose(bad)
        yield lambda bad=bad: slamicp.LaserScan(ranges, 0.0, 0.05, laser_pose=bad)
        yield lambda bad=bad: slamicp.LaserScan(ranges, 0.0, 0.05, odometry=bad)
        yield lambda bad=bad: slamicp.simulate_scan(slamicp.corridor_world(), bad)
    for bad in (None, 1.0, "abc", [1.0, 2.0], np.ones((9, 2)), np.ones(9, int), np.ones(9, complex), sparse()):
        yield lambda bad=bad: slamicp.LaserScan(bad, 0.0, 0.05)
    for bad in (NAN, INF, "0", None, 1j):
        yield lambda bad=bad: slamicp.LaserScan(ranges, bad, 0.05)
        yield lambda bad=bad: slamicp.LaserScan(ranges, 0.0, bad)
        yield lambda bad=bad: slamicp.LaserScan(ranges, 0.0, 0.05, stamp=bad)
    for bad in (None, 1, "scan", ranges, [ranges], [scan, None]):
        yield lambda bad=bad: localizer.update(bad)
        yield lambda bad=bad: slamicp.find_obstacles(fix, bad)
    yield lambda: slamicp.find_obstacles(fix, scan, min_points=0)
    yield lambda: slamicp.find_obstacles(fix, scan, min_far_points=0)
    yield lambda: slamicp.Map(points, scatter=0.0)
    yield lambda: slamicp.Localizer(good_map, obstacle_distance=-0.1)
    yield lambda: slamicp.find_obstacles(fix, scan, min_incidence_deg=95.0)
    yield lambda: slamicp.reconstruct_obstacles(points, gap=-1.0)
    yield lambda: slamicp.Localizer(in_space)
    yield lambda: slamicp.Localizer(good_map, no_such_option=1)
    yield lambda: localizer.set_map(in_space)
    yield lambda: localizer.set_map(without_lines)
    for bad in (None, 1, "/no/such/file.pcd", "/no/such/file.doc", "", b"\0"):
        for read in (slamicp.load_map, slamicp.load_cloud, slamicp.open_scan_log, slamicp.load_trajectory):
            yield lambda bad=bad, read=read: read(bad)
    for bad in (np.zeros((3, 3)), np.zeros((3, 4), int), None, np.full((1, 4), NAN)):
        yield lambda bad=bad: slamicp.save_trajectory("/tmp/never-written.tum", bad)
    yield lambda: slamicp.corridor_world("Z9")
    yield lambda: slamicp.simulate_drive(slamicp.corridor_world(), "no such route")
    yield lambda: slamicp.simulate_drive(slamicp.corridor_world(), np.zeros((1, 2)))


def refused(call):
    with pytest.raises((slamicp.Error, TypeError)) as caught:
        call()
    assert str(caught.value)
    if isinstance(caught.value, slamicp.Error):
        assert caught.value.code in ("error", "bad_points", "bad_pose", "bad_scan", "bad_options", "bad_state")


def test_each_is_refused():
    made = 0
    for made, call in enumerate(calls(), start=1):
        refused(call)
    assert made >= 200


def test_none_leaks():
    def peak_kib():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    def all_of_them():
        for call in calls():
            try:
                call()
            except (slamicp.Error, TypeError):
                pass

    for _ in range(3):
        all_of_them()
    before = peak_kib()
    for _ in range(15):
        all_of_them()
    # A leak of one map, scan or cloud a call would be megabytes.
    assert peak_kib() - before < 3000
