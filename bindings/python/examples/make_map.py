# SPDX-License-Identifier: Apache-2.0
"""A map from a log, by scan matching alone, and what it looks like."""

import matplotlib.pyplot as plt
import slamicp

run = slamicp.simulate_drive(slamicp.corridor_world(), "reference", speed=0.55, seed=3)
slamicp.save_scan_log("run.clf", run.scans[::10])

log = slamicp.open_scan_log("run.clf")
mapper = slamicp.Mapper(initial_pose=run.truth[0, 1:])
for scan in log:
    mapper.add(scan)
mapped = mapper.refined_map()
slamicp.save_map("map.pcd", mapped)
print(f"{log.format}: {len(log)} scans, a map of {len(mapped)} points, kept in map.pcd")

figure, axes = plt.subplots(figsize=(9, 4))
axes.plot(*mapped.points.T, ".", color="tab:blue", markersize=1)
axes.plot(*mapper.trajectory[:, 1:3].T, color="tab:green")
axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
figure.savefig("map.png", dpi=120, bbox_inches="tight")
