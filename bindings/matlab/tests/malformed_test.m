% Malformed calls: each is refused with an identifier, none crashes, none leaks.
1;

function calls = points_calls(good, make)
  % What is no real, full matrix of doubles of 2 or 3 rows with a finite point within 10^6 m.
  bad = {[], zeros(2, 0), zeros(0, 5), 5, 1:5, zeros(1, 9), zeros(4, 5), zeros(5, 2), zeros(2, 3, 2), nan(2, 5), inf(2, 5), ...
         -inf(3, 5), [nan inf; inf nan], 1e300 * ones(2, 5), -1e7 * ones(2, 5), complex(good, good), complex(good, 0 * good), ...
         sparse(good), single(good), int32(good), uint8(good), int64(good), logical(good > 0), 'points', {good}, ...
         struct('x', 1), @sin, true, '', {}};
  calls = cellfun(@(b) {@() make(b)}, bad);
end

function calls = number_calls(make, zero)
  bad = {NaN, Inf, -Inf, -1, '0.3', single(0.3), int32(1), 1i, sparse(1), [1 2], {1}, struct(), true, @sin, zeros(1, 0), ''};
  if zero
    bad{end + 1} = 0;
  end
  calls = cellfun(@(b) {@() make(b)}, bad);
end

function [made, wrong, first] = try_all(calls)
  made = 0;
  wrong = 0;
  first = '';
  for call = calls
    made = made + 1;
    identifier = 'nothing';
    try
      call{1}();
    catch problem
      identifier = problem.identifier;
    end
    if ! strncmp(identifier, 'slamicp:', 8)
      wrong = wrong + 1;
      first = sprintf('%s; number %d, %s, gave %s', first, made, func2str(call{1}), identifier);
    end
  end
end

function pages = resident()
  file = fopen('/proc/self/statm');
  numbers = fscanf(file, '%d');
  fclose(file);
  pages = numbers(2);
end

x = linspace(-2, 2, 80);
M = [x, x, 0 * x - 2, 0 * x + 2; 0 * x - 2, 0 * x + 2, x, x];
map = slamicp.Map(M);
map3 = slamicp.Map([M; 0 * M(1, :)]);
flat = slamicp.Map(M, 'neighbours', 0);
localizer = slamicp.Localizer(map);
ranges = 2 * ones(1, 90);

calls = [points_calls(M, @(b) SLAMICP(b, M)), points_calls(M, @(b) SLAMICP(M, b)), ...
         points_calls(M, @(b) SLAMICP(map, b)), points_calls(M, @(b) slamicp.Map(b)), ...
         points_calls(M, @(b) map.with_added(b)), points_calls(M, @(b) icpMex(b, M, eye(3), 0.3, 'point_to_plane')), ...
         points_calls(M, @(b) icpMex(M, b, eye(3), 0.3, 'point_to_plane'))];
calls = [calls, number_calls(@(b) SLAMICP(M, M, b), true), number_calls(@(b) SLAMICP(M, M, 0.3, 'point_to_plane', b), true), ...
         number_calls(@(b) SLAMICP(M, M, 0.3, 'point_to_plane', 9, [0 0 0], b), true), ...
         number_calls(@(b) slamicp.Map(M, 'radius', b), true), number_calls(@(b) slamicp.Map(M, 'cell', b), true), ...
         number_calls(@(b) slamicp.Map(M, 'neighbours', b), false), ...
         number_calls(@(b) slamicp.Localizer(map, 'max_correspondence_distance', b), true), ...
         number_calls(@(b) localizer.recover(b), true)];
for bad = {'', 'plane', 'POINT_TO_PLANE', 1, {'point_to_plane'}, ['a'; 'b'], repmat('x', 1, 1000), NaN, true}
  calls{end + 1} = @() SLAMICP(M, M, 0.3, bad{1});
  calls{end + 1} = @() icpMex(M, M, eye(3), 0.3, bad{1});
  calls{end + 1} = @() slamicp.Localizer(map, 'method', bad{1});
end
for bad = {1, [1 2], [1 2 3 4], [NaN 0 0], [0 Inf 0], [0 0 NaN], [1e300 0 0], 'abc', {1, 2, 3}, single([0 0 0]), ...
           int32([0 0 0]), [1i 0 0], sparse([0 0 0]), zeros(3), true(1, 3), struct()}
  calls{end + 1} = @() SLAMICP(M, M, 0.3, 'point_to_plane', 9, bad{1});
  calls{end + 1} = @() localizer.set_pose(bad{1});
  calls{end + 1} = @() localizer.update(ranges, 0, 0.07, 'odometry', bad{1});
  calls{end + 1} = @() localizer.update(ranges, 0, 0.07, 'laser_pose', bad{1});
end
for bad = {[], 1, eye(2), eye(4), nan(3), zeros(3), 2 * eye(3), inf(3), 'eye', single(eye(3)), 1i * eye(3), sparse(eye(3))}
  calls{end + 1} = @() icpMex(M, M, bad{1}, 0.3, 'point_to_plane');
end
for bad = {[], zeros(2), 'abc', {1}, int32(1:9), complex(1:9, 1:9), sparse(1:9), true(1, 9), zeros(1, 2, 3), struct()}
  calls{end + 1} = @() localizer.update(bad{1}, 0, 0.07);
end
for bad = {NaN, Inf, 'a', [], [1 2], 1i, single(1), {1}}
  calls{end + 1} = @() localizer.update(ranges, bad{1}, 0.07);
  calls{end + 1} = @() localizer.update(ranges, 0, bad{1});
  calls{end + 1} = @() localizer.update(ranges, 0, 0.07, 'stamp', bad{1});
end
for bad = {[], 1, 'map', {map}, struct(), localizer}
  calls{end + 1} = @() localizer.set_map(bad{1});
  if ! isequal(bad{1}, [])
    calls{end + 1} = @() slamicp.Localizer(bad{1});
  end
end
for bad = {-1, 0, 17, NaN, 1e300, 'a', [], {1}, 1i, single(1)}
  calls{end + 1} = @() slamicp_mex('map_size', bad{1});
  calls{end + 1} = @() slamicp_mex('localizer_obstacles', bad{1});
end
deleted = slamicp.Map(M);
delete(deleted);
calls = [calls, {@() SLAMICP(), @() SLAMICP(M), @() icpMex(), @() icpMex(M, M), @() slamicp.Map(), @() deleted.count(), ...
                 @() SLAMICP(deleted, M), @() slamicp.Localizer(deleted), @() SLAMICP(map3, M), @() SLAMICP(M, [M; M(1, :)]), ...
                 @() SLAMICP(flat, M), @() slamicp.Localizer(map3), @() slamicp.Localizer(flat), @() map3.with_added(M), ...
                 @() slamicp.Map(M, 'no_such_option', 1), @() slamicp.Map(M, 'reach'), @() slamicp.Map(M, 1, 2), ...
                 @() slamicp.Map(M, 'reach', 10), @() slamicp.Localizer(map, 'outlier_distance', -1), ...
                 @() localizer.obstacles(), @() localizer.update(ranges), @() localizer.update(ranges, 0, 0.07, 'stamp'), ...
                 @() localizer.update(ranges, 0, 0.07, 'no_such_option', 1), @() slamicp_mex(), @() slamicp_mex(1), ...
                 @() slamicp_mex('no_such_command'), @() slamicp_mex('align'), @() slamicp_mex('map_new'), ...
                 @() slamicp_mex('free'), @() slamicp_mex(repmat('x', 1, 100))}];

[made, wrong, first] = try_all(calls);
printf('%d calls, %d not refused as they should be %s\n', made, wrong, first);
assert(made >= 200 && wrong == 0);

% Good calls and bad ones over and over: memory stays where it is.
for k = 1:3
  try_all(calls);
end
before = resident();
for k = 1:12
  try_all(calls);
  for j = 1:20
    again = slamicp.Map(M);
    follow = slamicp.Localizer(again);
    [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(again, M, 0.3, 'point_to_plane', 9, [0.01 0.01 0.01]);
  end
end
grown = (resident() - before) * 4;
printf('memory grew by %d KiB over %d calls\n', grown, 12 * (made + 60));
assert(grown < 4096);
disp('passed');
