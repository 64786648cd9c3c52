# SPDX-License-Identifier: Apache-2.0
"""What a user of Python meets: arrays in and out, results, files, the simulator."""

import pathlib
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import slamicp

from conftest import START


def test_a_match_finds_the_pose_and_what_is_new(scan_points, map_points, guess):
    result = slamicp.align(scan_points, map_points, guess, outlier_distance=0.2)
    assert result.stop == "converged" and result.usable
    assert np.allclose(result.pose, START, atol=0.01)
    assert len(result.outliers) >= 15
    assert np.array_equal(result.outliers_in_map, result.transformed_scan[result.outliers])
    assert len(result.updated_map) == len(map_points) + len(result.outliers)
    assert np.allclose(result.transform[:2, :2] @ scan_points[0] + result.transform[:2, 2], result.transformed_scan[0])
    by_brute_force = np.min(np.linalg.norm(map_points - result.transformed_scan[7], axis=1))
    assert result.match_distances[7] == pytest.approx(by_brute_force, abs=1e-12)
    assert "converged" in repr(result)


def test_points_go_in_and_out_without_a_copy(map_points, corridor_map, scan_points):
    assert corridor_map.points.base is not None and not corridor_map.points.flags.owndata
    assert np.array_equal(corridor_map.points, map_points)
    assert np.shares_memory(corridor_map.points, corridor_map.points)
    with pytest.raises(ValueError):
        corridor_map.points[0, 0] = 1.0
    # Other floats and orders are copied, with the same result.
    icp = slamicp.Icp()
    expected = icp.align(corridor_map, scan_points, START).pose
    assert np.array_equal(icp.align(corridor_map, np.asfortranarray(scan_points), START).pose, expected)
    in_float32 = scan_points.astype(np.float32)
    assert np.array_equal(
        icp.align(corridor_map, in_float32, START).pose, icp.align(corridor_map, in_float32.astype(float), START).pose
    )


def test_a_view_keeps_its_owner_alive(map_points):
    points = slamicp.Map(map_points).points
    outliers = slamicp.align(map_points[:300] + 5.0, map_points, max_correspondence_distance=0.1).outliers_in_map
    for _ in range(20):
        slamicp.Map(map_points + 1.0)
    assert np.array_equal(points, map_points)
    assert np.isfinite(outliers).all()


def test_an_icp_computes_what_it_is_asked_for(corridor_map, scan_points, guess):
    icp = slamicp.Icp(outlier_distance=0.2)
    bare = icp.align(corridor_map, scan_points, guess, outliers=False)
    assert len(bare.outliers) == len(bare.transformed_scan) == len(bare.match_indices) == 0
    full = icp.align(
        corridor_map, scan_points, guess, transformed_scan=True, updated_map=True, matches=True, covariance=True
    )
    assert np.array_equal(bare.pose, full.pose)
    assert len(full.transformed_scan) == len(scan_points)
    assert full.covariance[0, 0] > 0.0


def test_a_match_in_space():
    random = np.random.default_rng(3)
    corner = random.uniform(0.0, 3.0, (3000, 3))
    corner[np.arange(3000), np.arange(3000) % 3] = 0.0
    angle = 0.05
    turn = np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    seen = (corner - (0.03, -0.02, 0.01)) @ turn
    result = slamicp.align(seen, corner)
    assert isinstance(result, slamicp.IcpResult3)
    assert np.allclose(result.pose, (0.03, -0.02, 0.01, 0.0, 0.0, angle), atol=0.005)
    assert np.allclose(result.transform[:3, :3], turn, atol=0.003)
    again = slamicp.Icp().align(slamicp.Map(corner), seen, result.pose)
    assert np.allclose(again.pose, result.pose, atol=0.002)


def test_maps_grow_shrink_and_answer(map_points):
    grown = slamicp.Map(map_points).with_added(np.array([[100.0, 100.0]]))
    assert len(grown) == len(map_points) + 1 and grown.version == 1 and grown.dimension == 2
    indices, distances = grown.nearest(np.array([[100.05, 100.0], [50.0, 50.0]]), 0.3)
    assert indices.tolist() == [len(map_points), -1]
    assert distances[0] == pytest.approx(0.05) and np.isinf(distances[1])
    assert grown.with_removed([len(map_points)]).nearest(np.array([[100.05, 100.0]]), 0.3)[0][0] == -1


def test_a_localizer_follows_a_drive(corridor, corridor_map):
    run = slamicp.simulate_drive(corridor, "reference", speed=0.55, seed=2)
    localizer = slamicp.Localizer(corridor_map, outlier_distance=0.1)
    localizer.set_pose(run.truth[0, 1:])
    fixes = [localizer.update(scan) for scan in run.scans[:160:8]]
    assert all(fix.usable and fix.state == "tracking" for fix in fixes)
    errors = [np.hypot(*(fix.pose - truth)[:2]) for fix, truth in zip(fixes, run.truth[:160:8, 1:])]
    assert max(errors) < 0.05
    fix = fixes[0]  # a later update leaves it alone
    assert np.array_equal(fix.stamp, run.truth[0, 0])
    assert len(fix.points) == len(fix.beams) and fix.inliers > 500
    assert fix.covariance.shape == (3, 3) and 0.5 < fix.probability <= 1.0
    assert len(fix.map) == len(corridor_map)


def test_obstacles_stand_where_the_box_stands(corridor_map, scan, guess):
    localizer = slamicp.Localizer(corridor_map, outlier_distance=0.1)
    localizer.set_pose(guess)
    fix = localizer.update(scan)
    obstacles = slamicp.find_obstacles(fix, scan)
    assert obstacles and obstacles[0].width <= 0.6
    assert obstacles[0].ray_class == "obstacle" and np.linalg.norm(obstacles[0].nearest - obstacles[0].centre) < 0.5
    assert obstacles[0].shape.kind in ("box", "line") and 0.1 < obstacles[0].shape.width < 0.6
    seen = fix.outliers_in_map
    assert np.min(np.linalg.norm(seen - obstacles[0].centre, axis=1)) < 0.4
    assert obstacles[0].corners.shape == (4, 2)
    assert slamicp.reconstruct_obstacles(np.tile(seen, (5, 1)), filter_neighbours=0)


def test_several_lasers_make_one_fix(corridor, corridor_map):
    front = slamicp.simulate_scan(corridor, START, seed=4)
    both = [front, slamicp.simulate_scan(corridor, START, seed=5)]
    localizer = slamicp.Localizer(corridor_map)
    localizer.set_pose(START)
    assert len(localizer.update(both).points) > 1.9 * len(front.points())


def test_without_a_map_scans_are_matched_to_scans(corridor):
    localizer = slamicp.Localizer()
    first = localizer.update(slamicp.simulate_scan(corridor, START, seed=1))
    moved = np.array(START) + (0.1, 0.0, 0.0)
    second = localizer.update(slamicp.simulate_scan(corridor, moved, seed=2))
    assert np.array_equal(first.pose, (0.0, 0.0, 0.0))
    assert np.hypot(*second.pose[:2]) == pytest.approx(0.1, abs=0.03)


def test_a_mapper_makes_a_map(corridor):
    run = slamicp.simulate_drive(corridor, "reference", speed=0.55)
    mapper = slamicp.Mapper(initial_pose=run.truth[0, 1:])
    assert mapper.map is None
    for scan in run.scans[:60:4]:
        mapper.add(scan)
    assert len(mapper.map) > 200 and len(mapper.refined_map()) > 200
    assert np.allclose(mapper.trajectory[:, 1:3], run.truth[:60:4, 1:3], atol=0.1)


def test_files_come_back_as_they_went(tmp_path, corridor, corridor_map, scan):
    cloud = np.array([[1.25, 2.5], [3.0, -4.0]])
    slamicp.save_cloud(tmp_path / "cloud.pcd", cloud, binary=True)
    assert np.array_equal(slamicp.load_cloud(tmp_path / "cloud.pcd"), cloud)
    slamicp.save_cloud(str(tmp_path / "cloud.xyz"), np.array([[1.0, 2.0, 3.0], [1.0, 2.0, 4.0]]))
    assert slamicp.load_cloud(str(tmp_path / "cloud.xyz")).shape == (2, 3)
    slamicp.save_map(tmp_path / "map.csv", corridor_map)
    assert np.allclose(slamicp.load_map(tmp_path / "map.csv").points, corridor_map.points, atol=1e-6)
    slamicp.save_scan_log(tmp_path / "run.clf", [scan, scan])
    log = slamicp.open_scan_log(tmp_path / "run.clf")
    assert len(log) == 2 and log.format == "CARMEN" and len(log[-1]) == len(scan)
    assert [len(one) for one in log] == [len(scan)] * 2
    trajectory = np.array([[1.0, 2.0, 3.0, 0.5], [2.0, 2.5, 3.5, -0.5]])
    slamicp.save_trajectory(tmp_path / "path.tum", trajectory)
    assert np.allclose(slamicp.load_trajectory(tmp_path / "path.tum"), trajectory, atol=1e-6)
    slamicp.save_world(tmp_path / "world.yaml", corridor)
    assert np.allclose(slamicp.load_world(tmp_path / "world.yaml").walls, corridor.walls)


def test_the_simulator_is_seeded(corridor):
    once, again, other = (slamicp.simulate_scan(corridor, START, seed=seed).ranges for seed in (1, 1, 2))
    assert np.array_equal(once, again) and not np.array_equal(once, other)
    lidar = slamicp.hokuyo_utm30lx(range_noise=0.0)
    lidar.beams = 541
    assert len(slamicp.simulate_scan(corridor, START, lidar=lidar)) == 541
    boxed = corridor.with_box(10.0, 0.2, 0.4, 0.4).with_cylinder(8.0, 0.5, 0.1)
    assert slamicp.simulate_scan(boxed, START).ranges.sum() < once.sum() - 1.0


def test_other_threads_run_meanwhile(map_points):
    """A long call lets go of the interpreter: a thread gets on while it lasts."""
    many = np.tile(map_points, (12, 1)) + np.random.default_rng(1).normal(0.0, 0.01, (12 * len(map_points), 2))
    counted = []
    stop = threading.Event()

    def count():
        while not stop.is_set():
            counted.append(time.perf_counter())
            time.sleep(0.0005)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        before = time.perf_counter()
        slamicp.Map(many)
        after = time.perf_counter()
    finally:
        stop.set()
        thread.join()
    assert sum(before < moment < after for moment in counted) >= 3


def test_threads_take_turns_with_one_localizer(corridor_map, scan):
    localizer = slamicp.Localizer(corridor_map)
    localizer.set_pose(START)
    poses = []

    def work():
        for _ in range(20):
            poses.append(localizer.update(scan).pose)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(poses) == 80 and np.allclose(poses, START, atol=0.02)


def test_the_wheel_has_stubs_and_every_name_a_docstring():
    package = pathlib.Path(slamicp.__file__).parent
    assert (package / "py.typed").exists()
    stub = (package / "_core.pyi").read_text()
    compile(stub, "_core.pyi", "exec")
    for name in slamicp.__all__:
        assert name in stub or name == "Error"
        assert getattr(slamicp, name).__doc__, name


def test_the_wheel_brings_the_command():
    program = pathlib.Path(sys.executable).parent / "slamicp"
    told = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    assert slamicp.__version__ in told.stdout
