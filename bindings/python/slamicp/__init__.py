# SPDX-License-Identifier: Apache-2.0
"""slamicp: where a robot is in its map, how sure it is, and what stands there that the map does not know.

Units are m, rad and s. Points are NumPy arrays of float64, a point a row: (K, 2) in the plane, (K, 3) in space. A pose is
x, y, heading; in space x, y, z, roll, pitch, yaw with R = Rz(yaw) Ry(pitch) Rx(roll). Poses are T_map_robot: they take
robot coordinates into the map. Indices count from 0.

    import slamicp
    localizer = slamicp.Localizer(slamicp.load_map("corridor.pcd"), max_correspondence_distance=0.3)
    localizer.set_pose((5.9, -4.2, 1.556))
    for scan in slamicp.open_scan_log("run.clf"):
        fix = localizer.update(scan)
        if fix.usable:
            print(fix.pose, slamicp.find_obstacles(fix, scan))

Which when: align() for one pair of clouds; Icp with a Map for many scans against one map; Localizer for a robot that moves
through a map; Mapper to make the map. Arrays that results hand out are read-only views into them; copy to change.
"""

from ._core import (
    Error,
    Fix,
    Icp,
    IcpResult2,
    IcpResult3,
    LaserScan,
    LidarModel,
    Localizer,
    Map,
    Mapper,
    Obstacle,
    ScanLog,
    Shape,
    SimulatedRun,
    World,
    __version__,
    align,
    corridor_world,
    find_obstacles,
    hokuyo_utm30lx,
    load_cloud,
    load_map,
    load_trajectory,
    load_world,
    open_scan_log,
    real_hokuyo_utm30lx,
    reconstruct_obstacles,
    sample_map,
    save_cloud,
    save_map,
    save_scan_log,
    save_trajectory,
    save_world,
    simulate_drive,
    simulate_scan,
)

__all__ = [
    "Error",
    "Fix",
    "Icp",
    "IcpResult2",
    "IcpResult3",
    "LaserScan",
    "LidarModel",
    "Localizer",
    "Map",
    "Mapper",
    "Obstacle",
    "ScanLog",
    "Shape",
    "SimulatedRun",
    "World",
    "align",
    "corridor_world",
    "find_obstacles",
    "hokuyo_utm30lx",
    "load_cloud",
    "load_map",
    "load_trajectory",
    "load_world",
    "open_scan_log",
    "real_hokuyo_utm30lx",
    "reconstruct_obstacles",
    "sample_map",
    "save_cloud",
    "save_map",
    "save_scan_log",
    "save_trajectory",
    "save_world",
    "simulate_drive",
    "simulate_scan",
]
