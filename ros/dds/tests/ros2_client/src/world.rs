// SPDX-License-Identifier: Apache-2.0
//! A room, what a laser sees in it, and a robot that drives an arc there.
use crate::messages::{LaserScan, OccupancyGrid, Pose, Quaternion, Vector3};

/// In the plane: m, rad.
#[derive(Clone, Copy, Debug, Default)]
pub struct Planar {
    pub x: f64,
    pub y: f64,
    pub theta: f64,
}

impl Planar {
    pub fn then(self, other: Planar) -> Planar {
        let (sine, cosine) = self.theta.sin_cos();
        Planar {
            x: self.x + cosine * other.x - sine * other.y,
            y: self.y + sine * other.x + cosine * other.y,
            theta: self.theta + other.theta,
        }
    }
    pub fn of(position: Vector3, orientation: Quaternion) -> Planar {
        Planar { x: position.x, y: position.y, theta: 2.0 * orientation.z.atan2(orientation.w) }
    }
    pub fn position(self) -> Vector3 {
        Vector3 { x: self.x, y: self.y, z: 0.0 }
    }
    pub fn orientation(self) -> Quaternion {
        let (z, w) = (0.5 * self.theta).sin_cos();
        Quaternion { x: 0.0, y: 0.0, z, w }
    }
    pub fn pose(self) -> Pose {
        Pose { position: self.position(), orientation: self.orientation() }
    }
}

type Wall = [f64; 4];

const WIDTH: f64 = 12.0;
const HEIGHT: f64 = 8.0;
const ROOM: [Wall; 7] = [
    [0.0, 0.0, WIDTH, 0.0],
    [WIDTH, 0.0, WIDTH, HEIGHT],
    [WIDTH, HEIGHT, 0.0, HEIGHT],
    [0.0, HEIGHT, 0.0, 0.0],
    [8.0, 8.0, 8.0, 6.5],
    [8.0, 6.5, 10.0, 6.5],
    [3.0, 6.0, 4.0, 6.5],
];
/// What the map does not have: a box of 0.4 m beside the way.
pub const BOX: [f64; 2] = [5.0, 1.8];
const BOX_SIDE: f64 = 0.4;

fn all_walls() -> Vec<Wall> {
    let ([x, y], half) = (BOX, 0.5 * BOX_SIDE);
    let (left, right, low, high) = (x - half, x + half, y - half, y + half);
    let sides =
        [[left, low, right, low], [right, low, right, high], [right, high, left, high], [left, high, left, low]];
    ROOM.iter().copied().chain(sides).collect()
}

/// Along a ray to a wall [m].
fn distance(from: Planar, direction: f64, wall: Wall) -> Option<f64> {
    let (ray_y, ray_x) = direction.sin_cos();
    let (along_x, along_y) = (wall[2] - wall[0], wall[3] - wall[1]);
    let (to_x, to_y) = (wall[0] - from.x, wall[1] - from.y);
    let across = ray_x * along_y - ray_y * along_x;
    if across.abs() < 1e-12 {
        return None;
    }
    let range = (to_x * along_y - to_y * along_x) / across;
    let share = (to_x * ray_y - to_y * ray_x) / across;
    (range > 0.0 && (0.0..=1.0).contains(&share)).then_some(range)
}

pub fn scan(from: Planar) -> LaserScan {
    let (beams, angle_min, angle_max) = (541, -0.75 * std::f64::consts::PI, 0.75 * std::f64::consts::PI);
    let angle_increment = (angle_max - angle_min) / f64::from(beams - 1);
    let walls = all_walls();
    let ranges = (0..beams).map(|beam| {
        let direction = from.theta + angle_min + f64::from(beam) * angle_increment;
        let nearest = walls.iter().filter_map(|wall| distance(from, direction, *wall)).fold(f64::INFINITY, f64::min);
        nearest as f32
    });
    LaserScan {
        angle_min: angle_min as f32,
        angle_max: angle_max as f32,
        angle_increment: angle_increment as f32,
        range_min: 0.1,
        range_max: 30.0,
        ranges: ranges.collect(),
        ..Default::default()
    }
}

pub fn map() -> OccupancyGrid {
    let side: f64 = 0.05;
    let margin: f64 = 0.5;
    let cells = |length: f64| ((length + 2.0 * margin) / side).round() as usize + 1;
    let (width, height) = (cells(WIDTH), cells(HEIGHT));
    let mut data = vec![0i8; width * height];
    for wall in ROOM {
        let steps = 400;
        for step in 0..=steps {
            let share = f64::from(step) / f64::from(steps);
            let cell = |from: f64, to: f64| ((from + share * (to - from) + margin) / side).round() as usize;
            data[cell(wall[1], wall[3]) * width + cell(wall[0], wall[2])] = 100;
        }
    }
    // A wall's cell is the one whose middle is nearest.
    let origin = Planar { x: -margin - 0.5 * side, y: -margin - 0.5 * side, theta: 0.0 };
    OccupancyGrid {
        resolution: side as f32,
        width: width as u32,
        height: height as u32,
        origin: origin.pose(),
        data,
        ..Default::default()
    }
}

/// Where the robot is after so many seconds, 0.5 m/s on an arc; and where its wheels say that it is.
pub fn truth(seconds: f64) -> Planar {
    Planar { x: 2.0, y: 2.5, theta: 0.0 }.then(arc(0.5, 0.1, seconds))
}
pub fn wheels(seconds: f64) -> Planar {
    arc(0.505, 0.1, seconds)
}

fn arc(speed: f64, turn: f64, seconds: f64) -> Planar {
    let radius = speed / turn;
    let theta = turn * seconds;
    Planar { x: radius * theta.sin(), y: radius * (1.0 - theta.cos()), theta }
}
