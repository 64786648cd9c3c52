function figure_8(picture)
% figure_8(PICTURE)  The paper's Figure 8: one call gives the pose, the inliers (green), the outliers (red), and a map to which
% only the outliers are added. Writes a PNG.
  [M, T] = two_scans();
  [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, [1.05 -0.25 -0.33], 0.3);
  fprintf('P: x %.3f m, y %.3f m, %.2f deg after %d iterations, inliers at %.1f mm, %d outliers; the map has %d points\n', ...
         P(1), P(2), P(3) * 180 / pi, n, 1000 * md, numel(Oindx), size(uM, 2));
  inliers = tT;
  inliers(:, Oindx) = [];
  f = figure('visible', 'off');
  subplot(1, 2, 1);
  plot(M(1, :), M(2, :), 'b.', 'markersize', 4, inliers(1, :), inliers(2, :), 'g.', 'markersize', 4, ...
       Ocoords(1, :), Ocoords(2, :), 'r.', 'markersize', 4, P(1), P(2), 'ko');
  axis equal; axis([-2 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title('(a) inliers green, outliers red');
  subplot(1, 2, 2);
  plot(uM(1, :), uM(2, :), 'b.', 'markersize', 4);
  axis equal; axis([-2 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title(sprintf('(b) uM: %d points', size(uM, 2)));
  print(f, picture, '-dpng', '-S900,620');
  close(f);
end
