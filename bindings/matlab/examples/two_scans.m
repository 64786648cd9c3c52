function [M, T] = two_scans()
% [M, T] = two_scans()  Two scans of 1,081 beams over 270 deg from two_scans.csv, as points in the robot's frame, 2 x 1081 [m]:
% one where the robot starts, one after it has moved 1.1 m and turned by -21 deg. Made by the simulator, with 1 cm of noise.
  ranges = dlmread(fullfile(fileparts(mfilename('fullpath')), 'two_scans.csv'));
  angles = linspace(-135, 135, 1081) * pi / 180;
  M = [ranges(1, :) .* cos(angles); ranges(1, :) .* sin(angles)];
  T = [ranges(2, :) .* cos(angles); ranges(2, :) .* sin(angles)];
end
