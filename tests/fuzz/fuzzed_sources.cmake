# The sources that readers need, once more: a fuzzer sees only what is compiled for it.
set(source_dir ${PROJECT_SOURCE_DIR}/src)
set(fuzzed_sources ${source_dir}/error.cpp ${source_dir}/geometry/pose.cpp ${source_dir}/map/occupancy_grid.cpp
  ${source_dir}/scan/motion_track.cpp ${source_dir}/scan/laser_mount.cpp)
foreach(concept text output_file log_checks laser_offset carmen_messages carmen_log carmen_writer ranges_csv scan_log
                xyz pcd ply_header ply trajectory_file relations_file pgm png occupancy_yaml occupancy_cells
                file_bytes log_format compression decoders ros1_reader cdr ros_messages bag_records ros1_bag mcap database
                rosbag2_database rosbag2_files rosbag2 frame_tree laser_mount ros_recording ros_topics ros_robot
                ros_log spelling yaml_fields world_yaml world_writer)
  list(APPEND fuzzed_sources ${source_dir}/io/${concept}.cpp)
  string(SUBSTRING ${concept} 0 1 initial)
  set_source_files_properties(${source_dir}/io/${concept}.cpp PROPERTIES UNITY_GROUP ${initial})
endforeach()
foreach(concept world door person lidar random)
  list(APPEND fuzzed_sources ${source_dir}/simulation/${concept}.cpp)
endforeach()
add_library(slamicp_fuzzed OBJECT ${fuzzed_sources})
set_target_properties(slamicp_fuzzed PROPERTIES UNITY_BUILD_MODE GROUP)
target_compile_features(slamicp_fuzzed PUBLIC cxx_std_20)
target_include_directories(slamicp_fuzzed PUBLIC ${PROJECT_SOURCE_DIR}/include ${source_dir} ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(slamicp_fuzzed PUBLIC Eigen3::Eigen ${SLAMICP_IO_TARGETS})
# The latter lets PNGs through whose check sums are wrong.
target_compile_definitions(slamicp_fuzzed PUBLIC ${SLAMICP_IO_DEFINITIONS} FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)
slamicp_precompile(slamicp_fuzzed)
target_compile_options(slamicp_fuzzed PUBLIC -g1 -O1 -fno-omit-frame-pointer
  -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
