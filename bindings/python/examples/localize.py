# SPDX-License-Identifier: Apache-2.0
"""A robot drives down a corridor that it has a map of; what the map does not know is drawn red."""

import matplotlib.pyplot as plt
import numpy as np
import slamicp

map_points = slamicp.sample_map(slamicp.corridor_world(), seed=1)
run = slamicp.simulate_drive(slamicp.corridor_world("A2"), "reference", speed=0.55)

localizer = slamicp.Localizer(slamicp.Map(map_points), outlier_distance=0.1)
localizer.set_pose(run.truth[0, 1:])
poses, outliers = [], []
for scan in run.scans[::5]:
    fix = localizer.update(scan)
    if fix.usable:
        poses.append(fix.pose)
        outliers.append(fix.outliers_in_map)
poses, outliers = np.array(poses), np.concatenate(outliers)
errors = np.linalg.norm(poses[:, :2] - run.truth[::5, 1:3], axis=1)
print(f"{len(poses)} scans, position error {1000 * errors.mean():.1f} mm mean, {1000 * errors.max():.1f} mm largest")

figure, axes = plt.subplots(figsize=(9, 4))
axes.plot(*map_points.T, ".", color="tab:blue", markersize=1, label="map")
axes.plot(*poses[:, :2].T, color="tab:green", label="robot")
axes.plot(*outliers.T, ".", color="tab:red", markersize=2, label="outliers")
for obstacle in slamicp.reconstruct_obstacles(outliers):
    print(obstacle.brief())
    axes.fill(*obstacle.corners.T, fill=False, color="black")
axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", xlim=(2, 20))
axes.legend(loc="lower right")
figure.savefig("localize.png", dpi=120, bbox_inches="tight")
