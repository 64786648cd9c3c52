# SPDX-License-Identifier: Apache-2.0
"""The same scans as the C++ library had (bindings/tests/reference.cpp): the same poses and outliers, bit for bit."""

import os
import pathlib

import numpy as np
import pytest
import slamicp

FOLDER = pathlib.Path(os.environ["SLAMICP_REFERENCE"])


def read(name, columns=None):
    types = {".f64": np.float64, ".f32": np.float32, ".i32": np.int32}
    values = np.fromfile(FOLDER / name, types[pathlib.Path(name).suffix])
    return values if columns is None else values.reshape(-1, columns)


@pytest.mark.parametrize("method", ["line", "point"])
def test_a_match(method):
    result = slamicp.align(
        read("scan.f64", 2),
        read("map.f64", 2),
        read("guess.f64"),
        method=f"point_to_{method}",
        max_iterations=40,
        outlier_distance=0.2,
    )
    assert result.usable and len(result.outliers) > 10
    assert np.array_equal(result.pose, read(f"{method}_pose.f64"))
    assert result.mean_inlier_distance == read(f"{method}_mean.f64")[0]
    assert result.iterations == read(f"{method}_iterations.i32")[0]
    assert np.array_equal(result.outliers, read(f"{method}_outliers.i32"))
    assert np.array_equal(result.outliers_in_map, read(f"{method}_outliers_in_map.f64", 2))
    assert np.array_equal(result.transformed_scan, read(f"{method}_transformed.f64", 2))


def test_a_match_in_space():
    result = slamicp.align(read("space_scan.f64", 3), read("space_map.f64", 3))
    assert np.array_equal(result.transform[:3], read("space_transform.f64", 4))
    assert np.array_equal(result.outliers, read("space_outliers.i32"))


def test_a_run():
    angle_min, angle_increment, range_min, range_max = read("angles.f64")
    counts, outliers, boxes = read("counts.i32", 2), read("outliers.i32"), read("boxes.f64", 3)
    stamps, odometry, poses = read("stamps.f64"), read("odometry.f64", 3), read("poses.f64", 3)
    ranges = read("ranges.f32").reshape(len(stamps), -1)
    localizer = slamicp.Localizer(slamicp.Map(read("map.f64", 2)), outlier_distance=0.1)
    localizer.set_pose(read("start.f64"))
    seen = boxed = 0
    for k, stamp in enumerate(stamps):
        scan = slamicp.LaserScan(
            ranges[k],
            angle_min,
            angle_increment,
            stamp=stamp,
            range_min=range_min,
            range_max=range_max,
            odometry=odometry[k],
        )
        fix = localizer.update(scan)
        assert np.array_equal(fix.pose, poses[k])
        assert np.array_equal(fix.outliers, outliers[seen : seen + counts[k, 0]])
        obstacles = slamicp.find_obstacles(fix, scan)
        told = np.array([(*one.centre, one.width) for one in obstacles]).reshape(-1, 3)
        assert np.array_equal(told, boxes[boxed : boxed + counts[k, 1]])
        seen += counts[k, 0]
        boxed += counts[k, 1]
    assert seen == len(outliers) > 100 and boxed == len(boxes) > 10
