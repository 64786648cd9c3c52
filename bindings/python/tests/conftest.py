# SPDX-License-Identifier: Apache-2.0
import numpy as np
import pytest
import slamicp

START = (9.0, 0.2, 0.1)


@pytest.fixture(scope="session")
def corridor():
    return slamicp.corridor_world("A2")


@pytest.fixture(scope="session")
def map_points():
    return slamicp.sample_map(slamicp.corridor_world(), spacing=0.03, seed=5)


@pytest.fixture(scope="session")
def corridor_map(map_points):
    return slamicp.Map(map_points)


@pytest.fixture(scope="session")
def scan(corridor):
    return slamicp.simulate_scan(corridor, START, seed=3)


@pytest.fixture(scope="session")
def scan_points(scan):
    return scan.points()


@pytest.fixture(scope="session")
def guess():
    return np.array(START) + (0.05, -0.03, 0.02)
