function figure_6(picture)
% figure_6(PICTURE)  The paper's Figure 6: two scans, a reference M and one after the robot has moved, T. Writes a PNG.
  [M, T] = two_scans();
  f = figure('visible', 'off');
  subplot(1, 2, 1);
  plot(M(1, :), M(2, :), 'b.', 'markersize', 4);
  axis equal; axis([-3 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title('(a) M');
  subplot(1, 2, 2);
  plot(T(1, :), T(2, :), 'b.', 'markersize', 4);
  axis equal; axis([-3 6 -7 7]); set(gca, 'fontsize', 10); xlabel('x [m]'); ylabel('y [m]'); title('(b) T');
  print(f, picture, '-dpng', '-S900,620');
  close(f);
end
