% One round of scripts/measure bindings in Octave: seconds a scan by SLAMICP(M, ...), by SLAMICP(map, ...), by a Localizer.
1;
folder = getenv('SLAMICP_REFERENCE');
function values = read(folder, name, type, rows)
  file = fopen(fullfile(folder, name));
  values = fread(file, [rows, Inf], ['*' type]);
  fclose(file);
end
M = read(folder, 'map.f64', 'double', 2);
angles = read(folder, 'angles.f64', 'double', 1);
ranges = read(folder, 'ranges.f32', 'single', 1081)(:, 1);
guess = read(folder, 'start.f64', 'double', 1) + [0.02 0.02 0.01];
T = double(ranges)' .* [cos(angles(1) + (0:1080) * angles(2)); sin(angles(1) + (0:1080) * angles(2))];
map = slamicp.Map(M);
localizer = slamicp.Localizer(map);
function seconds = each(times, work)
  work();
  start = tic();
  for k = 1:times
    work();
  end
  seconds = toc(start) / times;
end
function follow(localizer, guess, ranges, angles)
  localizer.set_pose(guess);
  fix = localizer.update(ranges, angles(1), angles(2));
end
function match(M, T, guess)
  [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, guess, 0.3);
end
printf('%.9f %.9f %.9f\n', each(10, @() match(M, T, guess)), each(200, @() match(map, T, guess)), ...
       each(200, @() follow(localizer, guess, ranges, angles)));
