// SPDX-License-Identifier: Apache-2.0
// node write.mjs SCANS.json OUT.mcap none|lz4|zstd: the scans [{stamp, ranges}, ...] as messages of ROS 2, in chunks.
import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import * as zstd_module from "@foxglove/wasm-zstd";
import { McapWriter } from "@mcap/core";
import lz4 from "lz4js";
import { readFileSync, writeFileSync } from "node:fs";

const separator = "=".repeat(80);
const definition = `std_msgs/Header header
float32 angle_min
float32 angle_max
float32 angle_increment
float32 time_increment
float32 scan_time
float32 range_min
float32 range_max
float32[] ranges
float32[] intensities
${separator}
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
${separator}
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;

const [scans_file, out_file, compression] = process.argv.slice(2);
const zstd = zstd_module.default ?? zstd_module;
await zstd.isLoaded;
const compress = { lz4: (bytes) => lz4.compress(bytes), zstd: (bytes) => zstd.compress(bytes, 3) }[compression];

class Memory {
  pieces = [];
  size = 0n;
  async write(bytes) {
    this.pieces.push(Buffer.from(bytes));
    this.size += BigInt(bytes.byteLength);
  }
  position() {
    return this.size;
  }
}

const memory = new Memory();
const writer = new McapWriter({
  writable: memory,
  chunkSize: 20000,
  compressChunk: compress && ((bytes) => ({ compression, compressedData: compress(bytes) })),
});
await writer.start({ profile: "ros2", library: "slamicp oracle" });
const schemaId = await writer.registerSchema({
  name: "sensor_msgs/msg/LaserScan",
  encoding: "ros2msg",
  data: new TextEncoder().encode(definition),
});
const channelId = await writer.registerChannel({
  schemaId,
  topic: "/scan",
  messageEncoding: "cdr",
  metadata: new Map([["offered_qos_profiles", ""]]),
});
const serializer = new MessageWriter(parse(definition, { ros2: true }));
const scans = JSON.parse(readFileSync(scans_file));
for (const [sequence, { stamp, ranges }] of scans.entries()) {
  const sec = Math.floor(stamp);
  const nanosec = Math.round(1e9 * (stamp - sec));
  const time = BigInt(sec) * 1000000000n + BigInt(nanosec);
  const data = serializer.writeMessage({
    header: { stamp: { sec, nanosec }, frame_id: "laser" },
    angle_min: -1.5,
    angle_max: -1.5 + 0.01 * (ranges.length - 1),
    angle_increment: 0.01,
    time_increment: 0,
    scan_time: 0.1,
    range_min: 0.05,
    range_max: 30,
    ranges,
    intensities: [],
  });
  await writer.addMessage({ channelId, sequence, logTime: time, publishTime: time, data });
}
await writer.end();
writeFileSync(out_file, Buffer.concat(memory.pieces));
