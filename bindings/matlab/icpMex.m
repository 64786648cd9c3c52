function Tr = icpMex(M, T, Tr0, indist, method)
% icpMex  Match a scan to a map; get the transformation: the call of the library that SLAMICP followed.
%
%   Tr = icpMex(M, T, Tr0, indist, method)
%
%   M       map: 2 x K or 3 x K, a point a column [m]
%   T       scan: 2 x L or 3 x L [m]
%   Tr0     first guess: 3 x 3, in 3D 4 x 4, [R t; 0 1]. Usually the Tr of the scan before
%   indist  [m] pairs farther apart are never made; -1: any pair may be
%   method  'point_to_plane' or 'point_to_point'
%   Tr      takes points of T into the frame of M, as Tr0
%
% For programs written for it. SLAMICP gives the pose as such, and much more, at the same cost.
%
% See also SLAMICP.

  if nargin ~= 5
    error('slamicp:bad_call', 'icpMex takes five inputs: icpMex(M, T, Tr0, indist, method)');
  end
  rows = size(T, 1);
  if ~isa(Tr0, 'double') || ~isreal(Tr0) || issparse(Tr0) || ~isequal(size(Tr0), [rows + 1, rows + 1])
    error('slamicp:bad_pose', 'Tr0 must be a real %d x %d matrix [R t; 0 1]', rows + 1, rows + 1);
  end
  R = Tr0(1:rows, 1:rows);
  if ~all(isfinite(Tr0(:))) || norm(R' * R - eye(rows)) > 1e-3 || norm(Tr0(end, :) - [zeros(1, rows), 1]) > 1e-9
    error('slamicp:bad_pose', 'Tr0 must be [R t; 0 1] with a rotation R');
  end
  if isequal(indist, -1) && isa(M, 'double') && ~isempty(M)
    indist = norm(max(M, [], 2) - min(M, [], 2)) + 1;
  end
  Tr = slamicp_mex('transform', 0, M, T, indist, method, 200, pose_of(Tr0), indist);
end

function P = pose_of(Tr)
  if size(Tr, 1) == 3
    P = [Tr(1, 3), Tr(2, 3), atan2(Tr(2, 1), Tr(1, 1))];
    return
  end
  level = hypot(Tr(3, 2), Tr(3, 3));
  if level > 1e-9
    P = [Tr(1:3, 4)', atan2(Tr(3, 2), Tr(3, 3)), atan2(-Tr(3, 1), level), atan2(Tr(2, 1), Tr(1, 1))];
  else  % looking straight up or down: roll and yaw are the same turn
    P = [Tr(1:3, 4)', 0, atan2(-Tr(3, 1), level), atan2(-Tr(1, 2), Tr(2, 2))];
  end
end
