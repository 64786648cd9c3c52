# bench/measure/NAME.cpp becomes the program measure_NAME, run by `scripts/measure NAME`. Built on demand; the
# target slamicp_measurements builds them all.
find_package(nlohmann_json REQUIRED)  # their results, for machines
slamicp_headers_only(nlohmann_json::nlohmann_json nlohmann)
file(GLOB measurement_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/measure/*.cpp)
add_custom_target(slamicp_measurements)
foreach(source IN LISTS measurement_sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(measure_${name} ${source})
  target_link_libraries(measure_${name} PRIVATE slamicp_io nlohmann_json::nlohmann_json)
  # What tests know of data, some know too.
  target_include_directories(measure_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  slamicp_settings_for(measure_${name})
  set_target_properties(measure_${name} PROPERTIES EXCLUDE_FROM_ALL ON UNITY_BUILD OFF)
  add_dependencies(slamicp_measurements measure_${name})
endforeach()

option(SLAMICP_BUILD_BENCH "Build slamicp-bench, the comparison with peers (nanoflann; PCL and MRPT where found)" OFF)
if(SLAMICP_BUILD_BENCH)
  include(cmake/bench.cmake)
endif()
