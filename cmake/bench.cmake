# slamicp-bench: this library, the paper's agents and other libraries on the same scans; see bench/slamicp_bench.
# Peers that are not found are left out, and the program names them as missing.
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(nanoflann REQUIRED)  # the tree of the paper's agents
find_package(Threads REQUIRED)
find_package(PkgConfig)
if(PkgConfig_FOUND)
  # Not find_package(PCL): it wants VTK, MPI and a C compiler, and links them.
  pkg_check_modules(pcl_registration QUIET pcl_registration>=1.12)
endif()
find_package(mrpt-slam QUIET)

set(bench_dir ${PROJECT_SOURCE_DIR}/bench/slamicp_bench)
file(GLOB bench_sources CONFIGURE_DEPENDS ${bench_dir}/*.cpp)
list(REMOVE_ITEM bench_sources ${bench_dir}/pcl.cpp ${bench_dir}/mrpt.cpp)
add_executable(slamicp_bench ${bench_sources})
set_target_properties(slamicp_bench PROPERTIES OUTPUT_NAME slamicp-bench UNITY_BUILD OFF)
target_include_directories(slamicp_bench PRIVATE ${PROJECT_SOURCE_DIR}/bench)
target_link_libraries(slamicp_bench PRIVATE
  slamicp_io CLI11::CLI11 nlohmann_json::nlohmann_json nanoflann::nanoflann Threads::Threads)
slamicp_settings_for(slamicp_bench)

# micro_NAME: parts of the library by themselves (bench/micro/NAME.cpp).
find_package(benchmark REQUIRED)
file(GLOB micro_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/micro/*.cpp)
foreach(source IN LISTS micro_sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(micro_${name} ${source})
  target_link_libraries(micro_${name} PRIVATE slamicp_core benchmark::benchmark)
  slamicp_settings_for(micro_${name})
endforeach()

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" bench_flags)
target_compile_definitions(slamicp_bench PRIVATE
  SLAMICP_DATA_DIR="${SLAMICP_DATA_DIR}" SLAMICP_BENCH_FLAGS="${bench_flags}")

# The paper's brute force as it was built, and as good as a compiler makes it.
set_source_files_properties(${bench_dir}/brute_force_scalar.cpp PROPERTIES COMPILE_OPTIONS "-O2;-fno-tree-vectorize")
set_source_files_properties(${bench_dir}/brute_force_vectorized.cpp PROPERTIES
  COMPILE_OPTIONS "-O3;-ffinite-math-only;-fno-signed-zeros")

if(pcl_registration_FOUND)
  target_sources(slamicp_bench PRIVATE ${bench_dir}/pcl.cpp)
  # GCC 12 takes fright at Eigen's umeyama(), which PCL's point-to-point step calls.
  set_source_files_properties(${bench_dir}/pcl.cpp PROPERTIES COMPILE_OPTIONS -Wno-array-bounds)
  target_include_directories(slamicp_bench SYSTEM PRIVATE ${pcl_registration_INCLUDE_DIRS})
  target_link_libraries(slamicp_bench PRIVATE pcl_registration pcl_search pcl_kdtree pcl_common)
  target_compile_definitions(slamicp_bench PRIVATE SLAMICP_BENCH_WITH_PCL)
endif()
if(mrpt-slam_FOUND)
  target_sources(slamicp_bench PRIVATE ${bench_dir}/mrpt.cpp)
  target_link_libraries(slamicp_bench PRIVATE mrpt::slam)
  target_compile_definitions(slamicp_bench PRIVATE SLAMICP_BENCH_WITH_MRPT)
endif()

if(SLAMICP_BUILD_TESTS)
  find_program(SLAMICP_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH DOC "Python 3 for the tests; standard library only")
  find_program(SLAMICP_PYTHON python3 REQUIRED)
  add_test(NAME apps_bench COMMAND ${SLAMICP_PYTHON} -B ${PROJECT_SOURCE_DIR}/tests/apps/slamicp_bench.py)
  set_tests_properties(apps_bench PROPERTIES LABELS unit TIMEOUT 300 ENVIRONMENT "SLAMICP=$<TARGET_FILE:slamicp_bench>")
endif()
