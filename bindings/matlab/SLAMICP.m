function [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, indist, method, iter, Pprev, Ot)
% SLAMICP  Match a lidar scan to a map; get the robot's pose, and what the map does not know.
%
%   [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(M, T, indist, method, iter, Pprev, Ot)
%
% finds where the robot stands by the iterative closest point method, and lists the points of the scan that match nothing
% in the map: the outliers, which are the obstacles and the changes of the building. It is the call of Clotet and Palacin,
% Sensors 2023, 23(15), 6841, eq. (10). Only the outputs that are asked for are computed.
%
% Inputs
%   M       map: 2 x K or 3 x K, a point a column [m] (eq. 4); or a slamicp.Map, whose index is made once, not at each call
%   T       scan in the robot's frame, 2 x L or 3 x L [m] (eq. 5). Points that are not finite take no part.
%   indist  [m] a point closer than this to the map is an inlier; farther pairs are never made. Default 0.3
%   method  'point_to_plane' (in 2D to the line; the default) or 'point_to_point'
%   iter    most iterations. Default 50
%   Pprev   last known pose: [x y theta], in 3D [x y z roll pitch yaw] [m, rad]. Default zeros
%   Ot      [m] a point at least this far from every map point is an outlier. Default indist
% Inputs at the end may be left out, and any but M and T may be [] for its default.
%
% Outputs
%   P        pose of the robot in the map: [x y theta], in 3D [x y z roll pitch yaw], R = Rz(yaw) Ry(pitch) Rx(roll)
%   n        iterations made
%   md       mean distance of the inliers to their nearest map point [m]
%   Oindx    1 x N, which columns of T are outliers, from 1 to L
%   Ocoords  2 x N (3 x N), the outliers in the map's frame [m]
%   tT       2 x L (3 x L), the scan in the map's frame [m] (eq. 7)
%   uM       the map with the outliers behind it: [M Ocoords]
%
% Where nothing matches P is Pprev, and a warning slamicp:not_usable tells so (switch it off with
% warning('off', 'slamicp:not_usable')). Wrong inputs are errors slamicp:bad_points, slamicp:bad_options, slamicp:bad_pose,
% slamicp:bad_type, slamicp:bad_size, slamicp:bad_call, slamicp:bad_handle.
%
% Example
%   x = linspace(0, 6, 200);  y = linspace(0, 4, 150);
%   M = [x, x, 0*y, 0*y + 6; 0*x, 0*x + 4, y, y];         % a room
%   T = M - [2; 1.5];  T(:, end+1) = [1; 0.5];            % the room as seen from (2, 1.5), and something new in it
%   [P, n, md, Oindx, Ocoords] = SLAMICP(M, T, 0.3, 'point_to_plane', 50, [2.05 1.45 0.02])
%
% See also slamicp.Map, slamicp.Localizer, icpMex, build_mex.

  if nargin < 2
    error('slamicp:bad_call', 'SLAMICP needs at least a map and a scan: SLAMICP(M, T)');
  end
  if nargin < 3 || is_default(indist), indist = 0.3; end
  if nargin < 4 || is_default(method), method = 'point_to_plane'; end
  if nargin < 5 || is_default(iter), iter = 50; end
  if nargin < 7 || is_default(Ot), Ot = indist; end
  by_handle = isa(M, 'slamicp.Map');
  if by_handle, M = M.id; end
  if nargin < 6 || is_default(Pprev), Pprev = zeros(1, 3 * (size(T, 1) - 1)); end
  outputs = cell(1, max(nargout, 1));
  [outputs{:}] = slamicp_mex('align', double(by_handle), M, T, indist, method, iter, Pprev, Ot);
  P = outputs{1};
  if nargout > 1, n = outputs{2}; end
  if nargout > 2, md = outputs{3}; end
  if nargout > 3, Oindx = outputs{4}; end
  if nargout > 4, Ocoords = outputs{5}; end
  if nargout > 5, tT = outputs{6}; end
  if nargout > 6, uM = outputs{7}; end
end

% True for [] of numbers: '' is text, and wrong.
function yes = is_default(x)
  yes = isa(x, 'double') && isequal(size(x), [0 0]);
end
