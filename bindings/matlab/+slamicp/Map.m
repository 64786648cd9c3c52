% slamicp.Map  A map whose index is made once, for many scans.
%
%   map = slamicp.Map(points)                   2 x K or 3 x K, a point a column [m]
%   map = slamicp.Map(points, 'reach', 0.5, ...)
%
% Options: 'neighbours' (12; points that a line is fitted to, 0: none, for point_to_point only), 'min_neighbours' (5),
% 'radius' (0.5 m; farther ones take no part), 'cell' (0.05 m; of the index, 2D), 'reach' (0.3 m; the longest distance that
% is asked for, 2D, at most 15 cells).
%
%   [P, n, md, Oindx, Ocoords, tT, uM] = SLAMICP(map, T, indist, method, iter, Pprev, Ot)
%   grown = map.with_added(points)              another map, these points behind the old ones
%   points = map.points();   n = map.count();   d = map.dimension();
%
% A map never changes. Its memory goes with the object, or by delete(map).
%
% See also SLAMICP, slamicp.Localizer.
classdef Map < handle
  properties (SetAccess = private)
    handle = -1;  % of the map inside slamicp_mex
  end

  methods
    function self = Map(points, varargin)
      if nargin < 1
        error('slamicp:bad_call', 'slamicp.Map needs points: slamicp.Map(points)');
      end
      if isa(points, 'uint64') && isscalar(points)  % a handle, from with_added
        self.handle = double(points);
        return
      end
      self.handle = slamicp_mex('map_new', points, varargin{:});
    end

    function delete(self)
      handle = self.handle;
      self.handle = -1;
      if handle > 0
        slamicp_mex('free', handle);
      end
    end

    function grown = with_added(self, points)
      grown = slamicp.Map(uint64(slamicp_mex('map_add', self.handle, points)));
    end

    function points = points(self)
      points = slamicp_mex('map_points', self.handle);
    end

    function n = count(self)
      n = slamicp_mex('map_size', self.handle);
    end

    function d = dimension(self)
      [~, d] = slamicp_mex('map_size', self.handle);
    end
  end
end
