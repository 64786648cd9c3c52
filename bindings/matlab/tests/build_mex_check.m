% build_mex, as a user calls it, and one match with what it has built.
options = strsplit(getenv('SLAMICP_MEX_OPTIONS'));
build_mex(getenv('SLAMICP_MEX_BUILD'), options{:});
x = linspace(0, 6, 200);
y = linspace(0, 4, 150);
M = [x, x, 0 * y, 0 * y + 6; 0 * x, 0 * x + 4, y, y];
T = M - [2; 1.5];
T(:, end + 1) = [1; 0.5];
[P, ~, ~, Oindx] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, [2.05 1.45 0.02]);
assert(norm(P - [2 1.5 0]) < 1e-3);
assert(isequal(Oindx, columns(T)));
built = fullfile(fileparts(which('build_mex')), 'slamicp_mex.mex');
delete(built);
disp('passed');
