% What a user of SLAMICP meets: optional inputs and outputs, handles, the drop-in.
1;

function points = room(spacing)
  x = 0:spacing:6;
  y = 0:spacing:4;
  points = [x, x, 0 * y, 0 * y + 6; 0 * x, 0 * x + 4, y, y];
end

function points = seen_from(points, P)
  R = [cos(P(3)) -sin(P(3)); sin(P(3)) cos(P(3))];
  points = R' * (points - P(1:2)');
end

M = room(0.03);
truth = [2 1.5 0.3];
new = [3.0 3.1; 2.0 2.0];
T = [seen_from(M, truth), seen_from(new, truth)];
last = columns(T);
guess = truth + [0.05 -0.04 0.03];

% Every count of inputs and outputs.
[P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, guess, 0.3);
assert(norm(P - truth) < 2e-3 && isequal(size(P), [1 3]));
assert(n >= 1 && n <= 50 && md < 0.01);
assert(isequal(Oindx, [last - 1, last]));
assert(norm(Ocoords - new) < 0.01);
assert(isequal(Ocoords, tT(:, Oindx)));
assert(isequal(uM, [M, Ocoords]));
all_outputs = {P, n, md, Oindx, Ocoords, tT, uM};
for wanted = 1:7
  got = cell(1, wanted);
  [got{:}] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, guess);
  assert(isequal(got, all_outputs(1:wanted)));
end
assert(isequal(SLAMICP(M, T, [], [], [], guess, []), P));
assert(norm(SLAMICP(M, seen_from(M, [0.02 0.01 0.01])) - [0.02 0.01 0.01]) < 2e-3);
assert(norm(SLAMICP(M, T, 0.3, 'point_to_point', 200, truth + 0.005) - truth) < 0.01);

% Ot by itself: a small one finds what stands near a wall.
near = seen_from([3.0; 0.15], truth);
[~, ~, ~, Oindx] = SLAMICP(M, [T near], 0.3, 'point_to_plane', 50, guess);
assert(isequal(Oindx, [last - 1, last]));
[~, ~, ~, Oindx] = SLAMICP(M, [T near], 0.3, 'point_to_plane', 50, guess, 0.1);
assert(isequal(Oindx, [last - 1, last, last + 1]));

% Points that are not finite take no part, and keep their columns.
[~, ~, ~, Oindx] = SLAMICP(M, [[NaN; 0], T], 0.3, 'point_to_plane', 50, guess);
assert(isequal(Oindx, [last, last + 1]));

% Nothing matches: the pose is the guess, and a warning says so.
lastwarn('', '');
warning('off', 'slamicp:not_usable', 'local');
P = SLAMICP(M, T + 100, 0.3, 'point_to_plane', 50, [0 0 0]);
assert(isequal(P, [0 0 0]));
[~, identifier] = lastwarn();
assert(strcmp(identifier, 'slamicp:not_usable') || isempty(identifier));

% A map that stays.
map = slamicp.Map(M);
assert(map.count() == columns(M) && map.dimension() == 2 && isequal(map.points(), M));
[by_handle{1:7}] = SLAMICP(map, T, 0.3, 'point_to_plane', 50, guess, 0.3);
assert(norm(by_handle{1} - truth) < 2e-3 && isequal(by_handle{4}, all_outputs{4}));
grown = map.with_added(new);
[~, ~, ~, Oindx, Ocoords] = SLAMICP(grown, T, 0.3, 'point_to_plane', 50, guess);
assert(isempty(Oindx) && isequal(size(Ocoords), [2 0]) && map.count() == columns(M));
id = map.id;
delete(map);
try
  slamicp_mex('map_size', id);
  error('test', 'a deleted map answers');
catch problem
  assert(strcmp(problem.identifier, 'slamicp:bad_handle'));
end

% In 3D.
rand('twister', 1);
corner = 3 * rand(3, 4000);
corner(sub2ind(size(corner), mod(0:3999, 3) + 1, 1:4000)) = 0;
a = 0.05;
R = [cos(a) -sin(a) 0; sin(a) cos(a) 0; 0 0 1];
t = [0.03; -0.02; 0.04];
[P, n, md, Oindx, Ocoords, tT] = SLAMICP(corner, R' * (corner - t), 0.3, 'point_to_plane');
assert(isequal(size(P), [1 6]) && norm(P - [t' 0 0 a]) < 0.01 && isequal(size(tT), size(corner)));
Tr = icpMex(corner, R' * (corner - t), eye(4), 0.3, 'point_to_plane');
assert(isequal(size(Tr), [4 4]) && norm(Tr(1:3, 4) - t) < 0.01 && isequal(Tr(4, :), [0 0 0 1]));

% The older call.
R = [cos(0.3) -sin(0.3); sin(0.3) cos(0.3)];
Tr = icpMex(M, T, [R, guess(1:2)'; 0 0 1], 0.3, 'point_to_plane');
assert(norm(Tr - [R, truth(1:2)'; 0 0 1]) < 3e-3);
Tr = icpMex(M, seen_from(M, truth), [R, guess(1:2)'; 0 0 1], -1, 'point_to_plane');
assert(norm(Tr - [R, truth(1:2)'; 0 0 1]) < 0.01);

% Following a robot.
localizer = slamicp.Localizer(slamicp.Map(M), 'outlier_distance', 0.1, 'max_range', 20);
localizer.set_pose(guess);
angles = (0:719) * pi / 360;
directions = angles + truth(3);
ranges = min(max((6 - truth(1)) ./ cos(directions), -truth(1) ./ cos(directions)), ...
             max((4 - truth(2)) ./ sin(directions), -truth(2) ./ sin(directions)));
ranges(100:110) = 1.0;
fix = localizer.update(ranges, 0, pi / 360, 'stamp', 2.5);
assert(fix.usable && strcmp(fix.stop, 'converged') && fix.stamp == 2.5 && norm(fix.pose - truth) < 2e-3);
assert(isequal(fix.beams(fix.outliers), 100:110));
assert(isequal(size(fix.covariance), [3 3]) && issquare(fix.covariance) && fix.probability > 0.5);
obstacles = localizer.obstacles();
assert(numel(obstacles) == 1 && abs(obstacles.distance - 1.0) < 1e-6 && isequal(obstacles.points, fix.outliers));
again = localizer.update(single(ranges), 0, pi / 360, 'odometry', [0 0 0], 'laser_pose', [0 0 0]);
assert(norm(again.pose - truth) < 2e-3 && ~localizer.recover());

% Help is there, and says what the call takes.
text = evalc('help SLAMICP');
for word = {'indist', 'Oindx', 'Ocoords', 'point_to_plane', 'Example'}
  assert(! isempty(strfind(text, word{1})));
end
disp('passed');
