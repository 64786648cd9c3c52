function figure_7(picture)
% figure_7(PICTURE)  The paper's Figure 7: the older call gives the transformation alone, so the map grows by every point and
% its walls thicken. Writes a PNG.
  [M, T] = two_scans();
  guess = [cos(-0.33) -sin(-0.33) 1.05; sin(-0.33) cos(-0.33) -0.25; 0 0 1];
  Tr = icpMex(M, T, guess, 0.3, 'point_to_plane');
  tT = Tr(1:2, 1:2) * T + Tr(1:2, 3);
  uM = [M, tT];
  fprintf('Tr_fit: x %.3f m, y %.3f m, %.2f deg; the map has %d points\n', Tr(1, 3), Tr(2, 3), ...
         atan2(Tr(2, 1), Tr(1, 1)) * 180 / pi, size(uM, 2));
  f = figure('visible', 'off');
  subplot(1, 2, 1);
  plot(M(1, :), M(2, :), 'b.', 'markersize', 4, tT(1, :), tT(2, :), 'm.', 'markersize', 4, Tr(1, 3), Tr(2, 3), 'go');
  axis equal; axis([-2 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title('(a) tT in M');
  subplot(1, 2, 2);
  plot(uM(1, :), uM(2, :), 'b.', 'markersize', 4);
  axis equal; axis([-2 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title(sprintf('(b) uM: %d points', size(uM, 2)));
  print(f, picture, '-dpng', '-S900,620');
  close(f);
end
