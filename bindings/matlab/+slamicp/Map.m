% slamicp.Map  A map whose index is made once, for many scans.
%
%   map = slamicp.Map(points)                   2 x K or 3 x K, a point a column [m]
%   map = slamicp.Map(points, 'reach', 0.5, ...)
%
% Options: 'neighbours' (12; points that a line is fitted to, 0: none, for point_to_point only), 'min_neighbours' (5),
% 'radius' (0.5 m; farther ones take no part), 'cell' (0.05 m; of the index, 2D), 'reach' (0.3 m; the longest distance that
% is asked for, 2D, at most 15 cells), 'scatter' (1.3; lines that points scatter about more count less, 2D; Inf: none does).
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
    id = -1;  % of the map inside slamicp_mex
  end

  methods
    function self = Map(points, varargin)
      if nargin < 1
        error('slamicp:bad_call', 'slamicp.Map needs points: slamicp.Map(points)');
      end
      if isequal(points, 'with_added')  % for the method of this name
        self.id = slamicp_mex('map_add', varargin{:});
      else
        self.id = slamicp_mex('map_new', points, varargin{:});
      end
    end

    function delete(self)
      gone = self.id;
      self.id = -1;
      if gone > 0
        slamicp_mex('free', gone);
      end
    end

    function grown = with_added(self, points)
      grown = slamicp.Map('with_added', self.id, points);
    end

    function all_points = points(self)
      all_points = slamicp_mex('map_points', self.id);
    end

    function n = count(self)
      n = slamicp_mex('map_size', self.id);
    end

    function d = dimension(self)
      [~, d] = slamicp_mex('map_size', self.id);
    end
  end
end
