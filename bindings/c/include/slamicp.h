// SPDX-License-Identifier: Apache-2.0
//
// slamicp in C: where a robot is in its map, and what stands there that the map does not know.
//
//   slamicp_map* map = NULL;
//   slamicp_localizer* localizer = NULL;
//   slamicp_scan scan;
//   slamicp_fix fix;
//   slamicp_scan_init(&scan, sizeof scan);
//   slamicp_fix_init(&fix, sizeof fix);
//   slamicp_map_create(2, points, count, NULL, &map);
//   slamicp_localizer_create(map, NULL, &localizer);
//   slamicp_localizer_set_pose(localizer, (double[]){1.2, 0.4, 0.0});
//   scan.ranges = ranges, scan.count = 1081, scan.angle_min = ..., scan.angle_increment = ...;
//   if (slamicp_localizer_update(localizer, &scan, &fix) != SLAMICP_OK) puts(slamicp_last_error());
//
// Units are m, rad and s. Points stand one after the other: x0 y0 x1 y1 ... (in space x0 y0 z0 ...), which is the
// paper's 2 x K matrix in column-major order, eq. (4), (5). A pose in the plane is x, y, heading; in space x, y, z,
// roll, pitch, yaw with R = Rz(yaw) Ry(pitch) Rx(roll). Poses are T_map_robot: they take robot coordinates into the
// map. Indices count from 0.
//
// Errors. Every function that can fail returns a slamicp_status. Anything but SLAMICP_OK is wrong use or too little
// memory; slamicp_last_error() then says in words what is wrong and how to mend it. A call that fails changes nothing
// but that text, and what it should have filled in is as it was. What may happen on a good day (no overlap, a
// featureless corridor) is no error: it is the result's `stop`. No exception crosses this interface, nothing is
// printed, no thread is started.
//
// Ownership. Who creates a handle frees it, once; freeing NULL does nothing. A localizer keeps the map it was given,
// so the map's handle may be freed right away. What the library takes is copied before the call returns. Pointers that
// it hands out point into the handle they came from and are good until that handle's next call, or until it is freed.
//
// Threads. A map never changes after it was made: any number of threads may use it at once. A slamicp_icp and a
// slamicp_localizer belong to one thread at a time. slamicp_last_error() is the calling thread's own.
//
// Binary compatibility. Structs begin with their size, which slamicp_..._init(&it, sizeof it) fills in together with
// the defaults: fields are only ever added at the end, and a program built against an older header goes on to work. The
// symbols have the version SLAMICP_1.
#ifndef SLAMICP_H
#define SLAMICP_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(SLAMICP_C_BUILD)
#define SLAMICP_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(SLAMICP_C_STATIC)
#define SLAMICP_API __declspec(dllimport)
#elif defined(__GNUC__)
#define SLAMICP_API __attribute__((visibility("default")))
#else
#define SLAMICP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// How a call went.
typedef enum slamicp_status {
  SLAMICP_OK = 0,
  SLAMICP_NULL_POINTER = 1,  ///< an argument that must not be NULL was
  SLAMICP_BAD_SIZE = 2,      ///< a struct's size is not one that this library knows: call its _init
  SLAMICP_BAD_OPTIONS = 3,   ///< an option is out of its range
  SLAMICP_BAD_POINTS = 4,    ///< no finite point, too many, too far out, or of the wrong dimension
  SLAMICP_BAD_POSE = 5,      ///< not finite
  SLAMICP_BAD_SCAN = 6,      ///< angles or stamps that are not finite, too many beams
  SLAMICP_BAD_STATE = 7,     ///< not now: no scan yet, no such obstacle, a map without surfaces
  SLAMICP_OUT_OF_MEMORY = 8,
  SLAMICP_INTERNAL = 9  ///< our fault: please tell us
} slamicp_status;

/// "ok", "null_pointer", ...; "unknown" for any other number.
SLAMICP_API const char* slamicp_status_name(slamicp_status status);

/// What the last call of this thread that failed had to say; "" before the first. Good until the next that fails.
SLAMICP_API const char* slamicp_last_error(void);

/// Of the library, as "0.1.0".
SLAMICP_API const char* slamicp_version(void);

// --- Maps ------------------------------------------------------------------------------------------------------------

/// Points in 2 or 3 dimensions, the line or plane around each, and an index to find the nearest. Never changes.
typedef struct slamicp_map slamicp_map;

typedef struct slamicp_map_options {
  size_t size;
  int32_t neighbours;      ///< points that a line is fitted to: 0 (no lines, for point to point only) to 64; 12
  int32_t min_neighbours;  ///< with fewer within the radius a point has no line: 3 to neighbours; 5
  double radius;           ///< neighbours farther away take no part [m]; 0.5
  double cell;             ///< in the plane, side of the index's cells [m]: 0.005 to 0.25; 0.05
  double reach;            ///< in the plane, the longest distance that is asked for, at most 15 cells [m]; 0.3
  double scatter;          ///< in the plane, lines that points scatter about more than this count less; 1.3
} slamicp_map_options;

SLAMICP_API slamicp_status slamicp_map_options_init(slamicp_map_options* options, size_t size);

/// @param dimension  2 or 3
/// @param points     `count` points in the map's frame; those that are not finite keep their number and are never found
/// @param options    NULL: the defaults
SLAMICP_API slamicp_status slamicp_map_create(int32_t dimension, const double* points, size_t count,
                                              const slamicp_map_options* options, slamicp_map** map);
/// Another map: this one and more points behind it, which keeps this one's numbers. `map` stays as it is.
SLAMICP_API slamicp_status slamicp_map_with_added(const slamicp_map* map, const double* points, size_t count,
                                                  slamicp_map** grown);
SLAMICP_API void slamicp_map_free(slamicp_map* map);

SLAMICP_API int32_t slamicp_map_dimension(const slamicp_map* map);  ///< 0 for NULL
SLAMICP_API size_t slamicp_map_size(const slamicp_map* map);        ///< number of points; 0 for NULL
/// The map's points, good as long as the map is.
SLAMICP_API const double* slamicp_map_points(const slamicp_map* map);
/// The nearest point closer than `reach` [m]; *index is -1 and *distance infinite where there is none.
SLAMICP_API slamicp_status slamicp_map_nearest(const slamicp_map* map, const double* query, double reach,
                                               int32_t* index, double* distance);

// --- One match: the paper's call, eq. (10) ---------------------------------------------------------------------------

typedef enum slamicp_method {
  SLAMICP_POINT_TO_POINT = 0,
  SLAMICP_POINT_TO_LINE = 1,  ///< in space point to plane
  SLAMICP_POINT_TO_PLANE = 1
} slamicp_method;

typedef enum slamicp_kernel {
  SLAMICP_KERNEL_NONE = 0,
  SLAMICP_KERNEL_HUBER = 1,
  SLAMICP_KERNEL_CAUCHY = 2,
  SLAMICP_KERNEL_GEMAN_MCCLURE = 3,
  SLAMICP_KERNEL_TUKEY = 4
} slamicp_kernel;

/// Why a match ended. The pose can be used after the first two.
typedef enum slamicp_stop {
  SLAMICP_CONVERGED = 0,
  SLAMICP_MAX_ITERATIONS = 1,
  SLAMICP_DEGENERATE = 2,      ///< some direction is not held by any pair: the pose keeps the guess there
  SLAMICP_TOO_FEW_POINTS = 3,  ///< the pose is the guess
  SLAMICP_NO_OVERLAP = 4       ///< the pose is the guess
} slamicp_stop;

/// "converged", ...; "unknown" for any other number.
SLAMICP_API const char* slamicp_stop_name(int32_t stop);

typedef struct slamicp_icp_options {
  size_t size;
  int32_t method;                      ///< slamicp_method; SLAMICP_POINT_TO_LINE
  int32_t max_iterations;              ///< at least 1; 50
  double max_correspondence_distance;  ///< the paper's indist [m], above 0; 0.3
  double outlier_distance;             ///< the paper's O_t [m]; 0, the default, is the distance above
  double final_gate;                   ///< the solver's gate shrinks to this [m]; 0, the default: by the map's spacing
  double guess_share;                  ///< how much the guess itself counts, as a share of the pairs, 0 to 1; 0
  int32_t kernel;                      ///< slamicp_kernel; SLAMICP_KERNEL_NONE
  int32_t coarse_to_fine;              ///< 0: every step looks at all points; 1
  double kernel_scale;                 ///< where the kernel begins to doubt [m]; 0.05
  double translation_tolerance;        ///< converged when less is left to move [m]; 1e-4
  double rotation_tolerance;           ///< [rad]; 1e-4
} slamicp_icp_options;

SLAMICP_API slamicp_status slamicp_icp_options_init(slamicp_icp_options* options, size_t size);

/// What to compute besides the pose: an "or" of these. What is not asked for costs nothing.
enum {
  SLAMICP_MEAN_INLIER_DISTANCE = 1,  ///< and how many inliers there are
  SLAMICP_OUTLIER_INDICES = 2,
  SLAMICP_OUTLIERS_IN_MAP = 4,
  SLAMICP_TRANSFORMED_SCAN = 8,
  SLAMICP_UPDATED_MAP = 16,
  SLAMICP_MATCHES = 32,
  SLAMICP_COVARIANCE = 64,  ///< in the plane, point to line
  SLAMICP_STRAYS = 128,     ///< what a localizer's obstacles are looked for in; without it, its outliers
  SLAMICP_ALL_OUTPUTS = 255
};

/// What a scan point is to the map, at the final pose.
typedef enum slamicp_point_class {
  SLAMICP_NEITHER = 0,
  SLAMICP_INLIER = 1,   ///< closer than max_correspondence_distance
  SLAMICP_OUTLIER = 2,  ///< at least outlier_distance from every map point
  SLAMICP_BOTH = 3      ///< where outlier_distance is the smaller one
} slamicp_point_class;

typedef struct slamicp_match {
  int32_t map_index;    ///< the nearest map point; -1: none within the larger of the two distances
  int32_t point_class;  ///< slamicp_point_class
  double distance;      ///< to that point [m]; infinite where there is none
} slamicp_match;

/// The outputs of the paper's call. Pointers are NULL, and counts 0, for what was not asked for.
typedef struct slamicp_result {
  size_t size;
  int32_t dimension;
  int32_t stop;                 ///< slamicp_stop
  int32_t usable;               ///< 1 if the pose can be used
  int32_t iterations;           ///< the paper's n
  double pose[6];               ///< the paper's P: x y heading, or x y z roll pitch yaw
  double transform[16];         ///< the same, T_map_robot as a 3 x 3 (in space 4 x 4) matrix, row by row
  double covariance[9];         ///< of the error (ahead, left, heading), row by row; zero where it was not asked for
  double mean_inlier_distance;  ///< the paper's m_d [m]
  size_t inliers;
  size_t points;  ///< of the scan
  size_t outliers;
  size_t updated_map_points;
  const int32_t* outlier_indices;  ///< the paper's O_indx, rising, counted from 0
  const double* outliers_in_map;   ///< the paper's O_coords
  const double* transformed_scan;  ///< the paper's tT: one for each of `points`
  const double* updated_map;       ///< the paper's uM: the map's points, then the outliers
  const slamicp_match* matches;    ///< one for each of `points`
} slamicp_result;

SLAMICP_API slamicp_status slamicp_result_init(slamicp_result* result, size_t size);

/// Matches scans to maps; keeps its memory from one match to the next.
typedef struct slamicp_icp slamicp_icp;

/// @param options  NULL: the defaults
SLAMICP_API slamicp_status slamicp_icp_create(const slamicp_icp_options* options, slamicp_icp** icp);
SLAMICP_API void slamicp_icp_free(slamicp_icp* icp);

/// @param scan     `count` points in the robot's frame, of the map's dimension; those not finite take no part
/// @param guess    where the robot should be, 3 or 6 numbers
/// @param outputs  an "or" of SLAMICP_MEAN_INLIER_DISTANCE, ...
SLAMICP_API slamicp_status slamicp_icp_align(slamicp_icp* icp, const slamicp_map* map, const double* scan, size_t count,
                                             const double* guess, uint32_t outputs, slamicp_result* result);
/// One match against points whose index is made for this call alone; `scatter` is infinite, as for a scan. Who has many
/// scans makes a map.
SLAMICP_API slamicp_status slamicp_icp_align_points(slamicp_icp* icp, int32_t dimension, const double* target,
                                                    size_t target_count, const double* scan, size_t count,
                                                    const double* guess, uint32_t outputs, slamicp_result* result);

// --- Following a robot -----------------------------------------------------------------------------------------------

/// One sweep of a planar lidar. Beam i points to angle_min + i * angle_increment in the laser's frame (x ahead, y to
/// the left) and was measured at stamp + i * time_increment. NaN, infinite, 0, below range_min, at or above range_max:
/// no return.
typedef struct slamicp_scan {
  size_t size;
  double stamp;              ///< [s]
  double time_increment;     ///< [s]; 0: all beams at once
  double angle_min;          ///< [rad]
  double angle_increment;    ///< [rad]
  double range_min;          ///< [m]; 0
  double range_max;          ///< [m]; 1e9
  const float* ranges;       ///< `count` of them [m]
  size_t count;              ///< at most 10^7
  double T_robot_laser[3];   ///< where the laser sits: x, y, heading; 0, 0, 0
  double T_odom_robot[3];    ///< the robot's pose by its wheels, where has_odometry is not 0
  double T_first_last[3];    ///< its motion from first to last beam by its wheels, where has_sweep_motion is not 0
  int32_t has_odometry;      ///< 0
  int32_t has_sweep_motion;  ///< 0
} slamicp_scan;

SLAMICP_API slamicp_status slamicp_scan_init(slamicp_scan* scan, size_t size);

typedef struct slamicp_localizer_options {
  size_t size;
  int32_t method;                      ///< slamicp_method; SLAMICP_POINT_TO_LINE
  int32_t max_iterations;              ///< 50
  double max_correspondence_distance;  ///< the paper's indist [m]; 0.3
  double outlier_distance;             ///< the paper's O_t [m]; 0, the default, is the distance above
  double final_gate;                   ///< as slamicp_icp_options has it
  double guess_share;                  ///< as slamicp_icp_options has it
  int32_t kernel;                      ///< as slamicp_icp_options has it
  uint32_t outputs;                    ///< mean inlier distance, outliers, covariance and strays
  double kernel_scale;                 ///< [m]
  double min_range;                    ///< shorter readings are left out [m]; 0
  double max_range;                    ///< readings at or beyond are left out [m]; 1e9
  int32_t use_odometry;                ///< predict by the scans' odometry, where they have it; 1
  int32_t deskew;                      ///< undo the motion within a scan that has a time_increment; 1
  double obstacle_distance;            ///< of a stray from the map's surface [m]; 0, the default, is by the noise
} slamicp_localizer_options;

SLAMICP_API slamicp_status slamicp_localizer_options_init(slamicp_localizer_options* options, size_t size);

typedef enum slamicp_state {
  SLAMICP_TRACKING = 0,
  SLAMICP_STATE_DEGENERATE = 1,  ///< right as far as scans tell, which is not in every direction
  SLAMICP_SUSPECT = 2,           ///< what the scans show does not fit the map here
  SLAMICP_LOST = 3               ///< so for a while
} slamicp_state;

/// "tracking", ...; "unknown" for any other number.
SLAMICP_API const char* slamicp_state_name(int32_t state);

/// What one scan told.
typedef struct slamicp_fix {
  size_t size;
  double stamp;                 ///< of the scan [s]
  double pose[3];               ///< T_map_robot: x, y, heading
  double predicted[3];          ///< before the match
  double covariance[9];         ///< of the error as seen from the robot (ahead, left, heading), row by row
  double blind_direction[2];    ///< unit vector in the map that the scan does not hold; 0, 0 where there is none
  double probability;           ///< that the pose is right, calibrated; 0 to 1
  double awareness;             ///< share of the surroundings that the map explains; 0 to 1
  double mean_inlier_distance;  ///< [m]
  int32_t stop;                 ///< slamicp_stop
  int32_t usable;               ///< 1 if the pose can be used
  int32_t state;                ///< slamicp_state
  int32_t iterations;
  size_t inliers;
  size_t points;  ///< returns that were used
  size_t outliers;
  const double* points_in_robot;   ///< one for each of `points`
  const int32_t* beams;            ///< the beam of each of `points`
  const int32_t* outlier_indices;  ///< into the points, rising
  const double* outliers_in_map;
  const double* transformed_scan;  ///< NULL unless asked for
  const slamicp_match* matches;    ///< NULL unless asked for
} slamicp_fix;

SLAMICP_API slamicp_status slamicp_fix_init(slamicp_fix* fix, size_t size);

/// Follows a robot through its map, scan by scan.
typedef struct slamicp_localizer slamicp_localizer;

/// @param map      of 2 dimensions; NULL: none, each scan is matched to the one before
/// @param options  NULL: the defaults
SLAMICP_API slamicp_status slamicp_localizer_create(const slamicp_map* map, const slamicp_localizer_options* options,
                                                    slamicp_localizer** localizer);
SLAMICP_API void slamicp_localizer_free(slamicp_localizer* localizer);

/// Where the robot is now: x, y, heading. Motion is forgotten.
SLAMICP_API slamicp_status slamicp_localizer_set_pose(slamicp_localizer* localizer, const double* pose);
/// Another map, from the next scan on.
SLAMICP_API slamicp_status slamicp_localizer_set_map(slamicp_localizer* localizer, const slamicp_map* map);
/// Localizes one scan. Allocates nothing after the first, as long as scans do not grow.
/// @param fix  NULL: not wanted now, see slamicp_localizer_fix
SLAMICP_API slamicp_status slamicp_localizer_update(slamicp_localizer* localizer, const slamicp_scan* scan,
                                                    slamicp_fix* fix);
/// The last fix; before the first scan one at the pose that was set, not usable.
SLAMICP_API slamicp_status slamicp_localizer_fix(slamicp_localizer* localizer, slamicp_fix* fix);
/// Looks for the robot near where it was last trusted, where the state is suspect or lost: up to `budget` places a call
/// (a thousand take about half a millisecond), one call a scan. *found is 1 where it was found and the pose set anew.
SLAMICP_API slamicp_status slamicp_localizer_recover(slamicp_localizer* localizer, int32_t budget, int32_t* found);

// --- What stands there that the map does not know --------------------------------------------------------------------

/// What a ray that fits nothing in the map says about the map.
typedef enum slamicp_ray_class {
  SLAMICP_RAY_OBSTACLE = 0,  ///< ends in front of a mapped surface
  SLAMICP_RAY_GONE = 1,      ///< went through one: taken away, an open door, glass
  SLAMICP_RAY_UNMAPPED = 2,  ///< ends where the map has nothing
  SLAMICP_RAY_UNKNOWN = 3    ///< cannot be told
} slamicp_ray_class;

/// "obstacle", ...; "unknown" for any other number.
SLAMICP_API const char* slamicp_ray_class_name(int32_t ray_class);

typedef enum slamicp_shape {
  SLAMICP_SHAPE_UNKNOWN = 0,  ///< width and depth are those of the box around the points
  SLAMICP_SHAPE_LINE = 1,     ///< one straight side
  SLAMICP_SHAPE_CIRCLE = 2,
  SLAMICP_SHAPE_BOX = 3  ///< two sides at a right angle
} slamicp_shape;

/// "line", ...; "unknown" for any other number.
SLAMICP_API const char* slamicp_shape_name(int32_t shape);

typedef struct slamicp_obstacle_options {
  size_t size;
  int32_t min_points;        ///< fewer make no obstacle: at least 1; 3
  int32_t min_far_points;    ///< of which so many are at least the obstacle distance off the map: at least 1; 2
  double range_noise;        ///< of a range, 1 sigma [m]; 0.01
  double min_incidence_deg;  ///< the flattest incidence at which a surface still holds together [deg]; 10
} slamicp_obstacle_options;

SLAMICP_API slamicp_status slamicp_obstacle_options_init(slamicp_obstacle_options* options, size_t size);

typedef struct slamicp_obstacle {
  size_t size;
  double centre[2];        ///< of the smallest box around what was seen of it, in the map [m]
  double width;            ///< its longer side [m]
  double depth;            ///< its shorter side [m]
  double heading;          ///< of the longer side, in (-pi/2, pi/2] [rad]
  double distance;         ///< from the laser to its nearest seen point [m]
  double nearest[2];       ///< that point, in the map [m]
  double shape_centre[2];  ///< of the circle or box, or the middle of the line's seen part, in the map [m]
  double shape_width;      ///< its longer side, a circle's diameter [m]
  double shape_depth;      ///< its shorter side; 0 for a line [m]
  double shape_heading;    ///< of the longer side, in (-pi/2, pi/2] [rad]
  double radius;           ///< of a circle, else 0 [m]
  int32_t shape;           ///< slamicp_shape
  int32_t ray_class;       ///< slamicp_ray_class, of most of its rays
  int32_t width_seen;      ///< 1 if both ends of the longer side were seen; else the thing may be larger
  int32_t depth_seen;      ///< the same of the shorter side
  size_t points;
  const int32_t* point_indices;  ///< into the fix's points
} slamicp_obstacle;

SLAMICP_API slamicp_status slamicp_obstacle_init(slamicp_obstacle* obstacle, size_t size);

/// Groups what the map does not have of the last fix into obstacles, nearest first. @param count  how many there are
/// @param options  NULL: the defaults
SLAMICP_API slamicp_status slamicp_localizer_find_obstacles(slamicp_localizer* localizer,
                                                            const slamicp_obstacle_options* options, size_t* count);
/// One of those that were found. `index` counts from 0.
SLAMICP_API slamicp_status slamicp_localizer_obstacle(slamicp_localizer* localizer, size_t index,
                                                      slamicp_obstacle* obstacle);

#ifdef __cplusplus
}
#endif

#endif  // SLAMICP_H
