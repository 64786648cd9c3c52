% slamicp.Localizer  Follow a robot through its map, scan by scan.
%
%   localizer = slamicp.Localizer(map)          map: a slamicp.Map of 2 dimensions; []: each scan is matched to the last
%   localizer = slamicp.Localizer(map, 'outlier_distance', 0.1, ...)
%   localizer.set_pose([x y theta])             where the robot is now [m, rad]
%   fix = localizer.update(ranges, angle_min, angle_increment, 'stamp', t, 'odometry', [x y theta], ...)
%   obstacles = localizer.obstacles()           of the last fix, nearest first
%   found = localizer.recover(1000)             looks around where fix.state is 'suspect' or 'lost'
%   localizer.set_map(map)                      another map, from the next scan on
%
% Options: 'max_correspondence_distance' (0.3 m, the paper's indist), 'outlier_distance' (the same, Ot), 'obstacle_distance'
% (what obstacles begin at; by the noise), 'method', 'max_iterations' (50), 'final_gate', 'guess_share', 'min_range',
% 'max_range' [m], 'use_odometry' (1), 'deskew' (1).
%
% ranges: a vector, double or single [m]; beam i points to angle_min + (i - 1) * angle_increment [rad]; NaN, Inf and 0 are no
% returns. Of a scan: 'stamp' [s], 'time_increment' [s], 'range_min', 'range_max' [m], 'laser_pose' (where the laser sits on
% the robot) and 'odometry' (the robot's pose by its wheels), both [x y theta].
%
% fix is a struct: pose, predicted, covariance (of the error ahead, left, heading), stop, usable, state, probability,
% awareness, iterations, inliers, mean_inlier_distance, points (2 x K in the robot's frame), beams (1 x K, from 1), outliers
% (columns of points), outliers_in_map, stamp. An obstacle has centre, width, depth, heading (of the box around what was
% seen), distance, nearest, ray_class, points, and what it looks like: shape ('line', 'circle', 'box', 'unknown'),
% shape_centre, shape_width, shape_depth, shape_heading, radius, width_seen, depth_seen.
%
% See also SLAMICP, slamicp.Map.
classdef Localizer < handle
  properties (SetAccess = private)
    id = -1;  % of the localizer inside slamicp_mex
  end

  methods
    function self = Localizer(map, varargin)
      if nargin < 1
        map = [];
      end
      if isa(map, 'slamicp.Map')
        map = map.id;
      elseif isequal(map, [])
        map = 0;
      else
        error('slamicp:bad_handle', 'slamicp.Localizer needs a slamicp.Map, or [] for none');
      end
      self.id = slamicp_mex('localizer_new', map, varargin{:});
    end

    function delete(self)
      gone = self.id;
      self.id = -1;
      if gone > 0
        slamicp_mex('free', gone);
      end
    end

    function set_pose(self, P)
      slamicp_mex('localizer_pose', self.id, P);
    end

    function set_map(self, map)
      if ~isa(map, 'slamicp.Map')
        error('slamicp:bad_handle', 'set_map needs a slamicp.Map');
      end
      slamicp_mex('localizer_map', self.id, map.id);
    end

    function fix = update(self, ranges, angle_min, angle_increment, varargin)
      if nargin < 4
        error('slamicp:bad_call', 'update needs ranges, angle_min and angle_increment');
      end
      laser_pose = [];
      odometry = [];
      rest = {};
      for k = 1:2:numel(varargin) - 1
        if isequal(varargin{k}, 'laser_pose')
          laser_pose = varargin{k + 1};
        elseif isequal(varargin{k}, 'odometry')
          odometry = varargin{k + 1};
        else
          rest(end + 1:end + 2) = varargin(k:k + 1);
        end
      end
      if mod(numel(varargin), 2) == 1
        rest(end + 1) = varargin(end);
      end
      fix = slamicp_mex('localizer_update', self.id, ranges, angle_min, angle_increment, laser_pose, odometry, ...
                        rest{:});
    end

    function found = recover(self, budget)
      if nargin < 2
        budget = 1000;
      end
      found = slamicp_mex('localizer_recover', self.id, budget);
    end

    function found = obstacles(self)
      found = slamicp_mex('localizer_obstacles', self.id);
    end
  end
end
