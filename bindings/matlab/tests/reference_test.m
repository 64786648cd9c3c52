% The same scans as the C++ library had (bindings/tests/reference.cpp): the same poses and outliers, bit for bit.
1;

function values = read(name, rows)
  types = struct('f64', 'double', 'f32', 'single', 'i32', 'int32');
  file = fopen(fullfile(getenv('SLAMICP_REFERENCE'), name), 'r');
  assert(file > 0, ['there is no ' name]);
  values = fread(file, [rows, Inf], ['*' types.(name(end - 2:end))]);
  fclose(file);
end

function same(ours, theirs)
  assert(isequal(double(ours), double(theirs)));
end

M = read('map.f64', 2);
T = read('scan.f64', 2);
guess = read('guess.f64', 1);
methods = {'point_to_plane', 'point_to_point'};
names = {'line', 'point'};
for k = 1:2
  [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, 0.3, methods{k}, 40, guess, 0.2);
  same(P, read([names{k} '_pose.f64'], 1));
  same(n, read([names{k} '_iterations.i32'], 1));
  same(md, read([names{k} '_mean.f64'], 1));
  same(Oindx - 1, read([names{k} '_outliers.i32'], 1));
  same(Ocoords, read([names{k} '_outliers_in_map.f64'], 2));
  same(tT, read([names{k} '_transformed.f64'], 2));
  same(uM, [M, Ocoords]);
  assert(numel(Oindx) > 10);
end

Tr = icpMex(M, T, [cos(guess(3)) -sin(guess(3)) guess(1); sin(guess(3)) cos(guess(3)) guess(2); 0 0 1], 0.3, ...
            'point_to_plane');
P = read('line_pose.f64', 1);
assert(norm(Tr - [cos(P(3)) -sin(P(3)) P(1); sin(P(3)) cos(P(3)) P(2); 0 0 1]) < 1e-4);

M3 = read('space_map.f64', 3);
T3 = read('space_scan.f64', 3);
[P3, ~, ~, Oindx] = SLAMICP(M3, T3);
Tr = icpMex(M3, T3, eye(4), 0.3, 'point_to_plane');
transform = reshape(read('space_transform.f64', 1), 4, 3)';
same(Tr(1:3, :), transform);
same(P3(1:3)', transform(:, 4));
same(Oindx - 1, read('space_outliers.i32', 1));

angles = read('angles.f64', 1);
stamps = read('stamps.f64', 1);
ranges = reshape(read('ranges.f32', 1), [], numel(stamps));
odometry = read('odometry.f64', 3);
poses = read('poses.f64', 3);
counts = read('counts.i32', 2);
outliers = read('outliers.i32', 1);
boxes = read('boxes.f64', 3);
localizer = slamicp.Localizer(slamicp.Map(M), 'outlier_distance', 0.1);
localizer.set_pose(read('start.f64', 1));
seen = 0;
boxed = 0;
for k = 1:numel(stamps)
  fix = localizer.update(ranges(:, k), angles(1), angles(2), 'stamp', stamps(k), 'range_min', angles(3), ...
                         'range_max', angles(4), 'odometry', odometry(:, k));
  same(fix.pose', poses(:, k));
  same(fix.outliers - 1, outliers(seen + 1:seen + counts(1, k)));
  found = localizer.obstacles();
  assert(numel(found) == counts(2, k));
  for j = 1:numel(found)
    same([found(j).centre; found(j).width], boxes(:, boxed + j));
  end
  seen = seen + double(counts(1, k));
  boxed = boxed + double(counts(2, k));
end
assert(seen == numel(outliers) && seen > 100 && boxed == columns(boxes) && boxed > 10);
disp('passed');
