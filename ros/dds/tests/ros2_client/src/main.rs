// SPDX-License-Identifier: Apache-2.0
//! slamicp-ros2-client NODE: a robot in ROS_DOMAIN_ID that gives map, first pose, tf and scans as a ROS 2 node does, and
//! holds what node NODE ("/slamicp") says of them against where it is.
mod messages;
mod world;

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use messages::{Header, PointCloud2, PoseWithCovarianceStamped, TfMessage, Time, TransformStamped};
use ros2_client::qos::{Durability, History, WhenFull};
use ros2_client::{
    Context, ContextOptions, MessageInfo, MessageTypeName, Name, Node, NodeEvent, NodeName, NodeOptions, Publisher,
    QosProfile, Subscription, COMPILED_ROS_DISTRO,
};
use world::Planar;

const SCANS: usize = 100;
const INTERVAL: f64 = 0.1; // [s]

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn check(holds: bool, otherwise: &str) -> Outcome<()> {
    if holds {
        Ok(())
    } else {
        Err(otherwise.into())
    }
}

fn reliable(depth: usize) -> QosProfile {
    QosProfile::publisher_default().reliability_reliable(WhenFull::DEFAULT).history(History::KeepLast { depth })
}
fn latched() -> QosProfile {
    reliable(1).durability(Durability::TransientLocal)
}
fn sensor_data() -> QosProfile {
    QosProfile::subscription_default().reliability_best_effort().history(History::KeepLast { depth: 5 })
}

fn give<M: serde::Serialize>(
    node: &mut Node,
    name: &str,
    kind: (&str, &str),
    qos: QosProfile,
) -> Outcome<Publisher<M>> {
    let topic = node.create_topic(&Name::parse(name)?, MessageTypeName::new(kind.0, kind.1), &qos)?;
    Ok(node.create_publisher(&topic, Some(qos))?)
}
fn hear<M: 'static>(node: &mut Node, name: &str, kind: (&str, &str), qos: QosProfile) -> Outcome<Subscription<M>> {
    let topic = node.create_topic(&Name::parse(name)?, MessageTypeName::new(kind.0, kind.1), &qos)?;
    Ok(node.create_subscription(&topic, Some(qos))?)
}

const TF: (&str, &str) = ("tf2_msgs", "TFMessage");
const POSE: (&str, &str) = ("geometry_msgs", "PoseWithCovarianceStamped");
const SCAN: (&str, &str) = ("sensor_msgs", "LaserScan");
const CLOUD: (&str, &str) = ("sensor_msgs", "PointCloud2");
const GRID: (&str, &str) = ("nav_msgs", "OccupancyGrid");

fn header(stamp: Time, frame: &str) -> Header {
    Header { stamp, frame_id: frame.to_owned() }
}

fn transform(stamp: Time, frame: &str, child: &str, pose: Planar) -> TfMessage {
    let one = TransformStamped {
        header: header(stamp, frame),
        child_frame_id: child.to_owned(),
        translation: pose.position(),
        rotation: pose.orientation(),
    };
    TfMessage { transforms: vec![one] }
}

/// What has come, until it will do.
fn wait_for<T>(what: &str, mut found: impl FnMut() -> Outcome<Option<T>>) -> Outcome<T> {
    let end = Instant::now() + Duration::from_secs(10);
    while Instant::now() < end {
        if let Some(all) = found()? {
            return Ok(all);
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    Err(format!("there is no {what}").into())
}

/// The points that lie within so much of the box that the map does not have.
fn near_box(cloud: &PointCloud2, robot: Planar) -> usize {
    let value = |bytes: &[u8]| f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    let points = cloud.data.chunks(cloud.point_step as usize);
    let places = points.map(|point| robot.then(Planar { x: value(&point[0..4]), y: value(&point[4..8]), theta: 0.0 }));
    places.filter(|place| (place.x - world::BOX[0]).hypot(place.y - world::BOX[1]) < 0.4).count()
}

fn run(wanted: &str) -> Outcome<()> {
    let domain = std::env::var("ROS_DOMAIN_ID").unwrap_or_default().parse().unwrap_or(0);
    let context = Context::with_options(ContextOptions::new().domain_id(domain))?;
    let mut node = context.new_node(NodeName::new("/", "rust_robot")?, NodeOptions::new().enable_rosout(false))?;
    let spinner = node.spinner()?;
    std::thread::spawn(move || futures::executor::block_on(spinner.spin()));
    let events = node.status_receiver().ok_or("no spinner")?;

    let map = give(&mut node, "/map", GRID, latched())?;
    let mount = give(&mut node, "/tf_static", TF, latched())?;
    let wheels = give(&mut node, "/tf", TF, reliable(100))?;
    let first_pose = give(&mut node, "/initialpose", POSE, reliable(10))?;
    let laser = give(&mut node, "/scan", SCAN, sensor_data())?;
    let poses = hear::<PoseWithCovarianceStamped>(&mut node, "/amcl_pose", POSE, latched())?;
    let transforms = hear::<TfMessage>(&mut node, "/tf", TF, reliable(100))?;
    let outliers = hear::<PointCloud2>(&mut node, "/outliers", CLOUD, sensor_data())?;

    map.publish(messages::OccupancyGrid { header: header(Time::default(), "map"), ..world::map() })?;
    mount.publish(transform(Time::default(), "base_link", "laser", Planar::default()))?;
    let mut nodes = BTreeMap::new();
    wait_for("node that hears and speaks", || {
        while let Ok(event) = events.try_recv() {
            if let NodeEvent::ParticipantEntities(told) = event {
                for each in told.nodes() {
                    nodes.insert(each.fully_qualified_name(), format!("{each:?}"));
                }
            }
        }
        let hears = ["/scan", "/tf", "/initialpose", "/map", "/tf_static"].iter().all(|topic| {
            let ours = usize::from(*topic == "/tf"); // we hear tf too
            node.subscription_count(topic) > ours
        });
        let speaks = ["/amcl_pose", "/outliers"].iter().all(|topic| node.publisher_count(topic) > 0);
        Ok((hears && speaks && nodes.contains_key(wanted)).then_some(()))
    })
    .map_err(|problem| format!("{problem}; nodes: {:?}", nodes.keys()))?;
    println!("nodes: {:?}", nodes.keys().collect::<Vec<_>>());

    let start = world::truth(0.0);
    first_pose.publish(PoseWithCovarianceStamped {
        header: header(Time::default(), "map"),
        pose: start.pose(),
        ..Default::default()
    })?;
    std::thread::sleep(Duration::from_millis(200)); // the pose and a scan go by topics of their own

    let (mut worst, mut worst_turn, mut on_box) = (0.0f64, 0.0f64, 0);
    for number in 0..SCANS {
        let seconds = number as f64 * INTERVAL;
        let stamp = Time { sec: 1000 + seconds as i32, nanosec: (number % 10) as u32 * 100_000_000 };
        let (truth, odometry) = (world::truth(seconds), world::wheels(seconds));
        wheels.publish(transform(stamp, "odom", "base_link", odometry))?;
        laser.publish(messages::LaserScan { header: header(stamp, "laser"), ..world::scan(truth) })?;

        let (told, info): (_, MessageInfo) = wait_for(&format!("amcl_pose of scan {number}"), || {
            Ok(poses.take()?.filter(|(pose, _)| pose.header.stamp == stamp))
        })?;
        let writer = format!("{:?}", info.publisher_gid());
        check(nodes[wanted].contains(&writer), "amcl_pose is not among the node's writers")?;
        check(told.header.frame_id == "map" && told.covariance[0][0] > 0.0, "a pose without frame or covariance")?;
        let found = Planar::of(told.pose.position, told.pose.orientation);
        let correction = wait_for(&format!("tf of scan {number}"), || {
            Ok(transforms.take()?.map(|(all, _)| all.transforms).and_then(|all| {
                let ahead = Time { nanosec: (stamp.nanosec + 100_000_000) % 1_000_000_000, ..stamp };
                let ahead = Time { sec: stamp.sec + i32::from(ahead.nanosec < stamp.nanosec), ..ahead };
                all.into_iter().find(|each| each.header.frame_id == "map" && each.header.stamp == ahead)
            }))
        })?;
        check(correction.child_frame_id == "odom", "tf of another frame")?;
        let by_tf = Planar::of(correction.translation, correction.rotation).then(odometry);
        check((by_tf.x - found.x).hypot(by_tf.y - found.y) < 1e-6, "tf says another place than amcl_pose")?;
        let cloud = wait_for(&format!("outliers of scan {number}"), || {
            Ok(outliers.take()?.map(|(cloud, _)| cloud).filter(|cloud| cloud.header.stamp == stamp))
        })?;
        on_box += near_box(&cloud, truth);
        worst = worst.max((found.x - truth.x).hypot(found.y - truth.y));
        worst_turn = worst_turn.max((found.theta - truth.theta).abs());
    }
    println!(
        "{SCANS} scans: at most {:.1} mm and {:.2} degrees off; {on_box} outliers on the box that the map lacks",
        1e3 * worst,
        worst_turn.to_degrees()
    );
    check(worst < 0.03 && worst_turn.to_degrees() < 0.5, "too far off")?;
    check(on_box > 10 * SCANS, "the box is not seen")
}

fn main() {
    println!("ros2-client for {COMPILED_ROS_DISTRO}");
    let wanted = std::env::args().nth(1).unwrap_or("/slamicp".to_owned());
    if let Err(problem) = run(&wanted) {
        println!("{problem}");
        std::process::exit(1);
    }
}
