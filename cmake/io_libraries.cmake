# What slamicp::io reads and draws with, each where it is found: an option SLAMICP_WITH_NAME, and a definition of the same
# name for our sources.
#   SLAMICP_IO_MODULES      pkg-config modules found
#   SLAMICP_IO_PACKAGES     CMake packages found, for what has no module everywhere
#   SLAMICP_IO_LIBRARIES    what the linker calls those packages' libraries
#   SLAMICP_IO_TARGETS      what to link
#   SLAMICP_IO_DEFINITIONS  SLAMICP_WITH_NAME of each
set(SLAMICP_IO_MODULES "")
set(SLAMICP_IO_PACKAGES "")
set(SLAMICP_IO_LIBRARIES "")
set(SLAMICP_IO_TARGETS "")
set(SLAMICP_IO_DEFINITIONS "")
find_package(PkgConfig)
if(MINGW)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)  # beside our programs there are to be no other DLLs
endif()
option(SLAMICP_REQUIRE_LIBRARIES "Fail where a library that a SLAMICP_WITH_NAME asks for is not found" OFF)

# slamicp_io_missing(WHAT WITHOUT): what happens where it is missing.
function(slamicp_io_missing what without)
  if(SLAMICP_REQUIRE_LIBRARIES)
    message(FATAL_ERROR "slamicp: ${what} not found, ${without}")
  endif()
  message(STATUS "slamicp: ${what} not found, ${without}")
endfunction()

# slamicp_io_module(NAME MODULE PURPOSE WITHOUT): PURPOSE says what it is for, WITHOUT what happens where it is missing.
macro(slamicp_io_module name module purpose without)
  option(SLAMICP_WITH_${name} "${purpose}, where ${module} is found" ON)
  if(SLAMICP_WITH_${name})
    if(PkgConfig_FOUND)
      pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
    endif()
    if(TARGET PkgConfig::${module})
      list(APPEND SLAMICP_IO_MODULES ${module})
      list(APPEND SLAMICP_IO_TARGETS PkgConfig::${module})
      list(APPEND SLAMICP_IO_DEFINITIONS SLAMICP_WITH_${name})
    else()
      slamicp_io_missing(${module} "${without}")
    endif()
  endif()
endmacro()

# slamicp_io_package(NAME PACKAGE TARGET LIBRARY PURPOSE WITHOUT [VERSION]): the same for a CMake package.
macro(slamicp_io_package name package target library purpose without)
  option(SLAMICP_WITH_${name} "${purpose}, where ${package} is found" ON)
  if(SLAMICP_WITH_${name})
    find_package(${package} ${ARGN} QUIET)
    if(TARGET ${target})
      list(APPEND SLAMICP_IO_PACKAGES ${package})
      list(APPEND SLAMICP_IO_LIBRARIES ${library})
      list(APPEND SLAMICP_IO_TARGETS ${target})
      list(APPEND SLAMICP_IO_DEFINITIONS SLAMICP_WITH_${name})
    else()
      slamicp_io_missing(${package} "${without}")
    endif()
  endif()
endmacro()

slamicp_io_module(PNG cairo "Write PNG pictures; SVG needs nothing" "pictures are written as SVG only")
slamicp_io_module(LIBPNG libpng "Read map_server maps whose image is PNG" "map_server maps whose image is PNG are not read")
slamicp_io_module(LZ4 liblz4 "Read bags and MCAP files packed with lz4" "bags and MCAP files packed with lz4 are not read")
slamicp_io_package(BZ2 BZip2 BZip2::BZip2 bz2 "Read bags and logs packed with bzip2" "bags and logs packed with bzip2 are not read")
slamicp_io_module(GZIP zlib "Read logs packed with gzip" "logs packed with gzip are not read")
slamicp_io_module(XZ liblzma "Read logs packed with xz" "logs packed with xz are not read")
slamicp_io_module(ZSTD libzstd "Read logs and MCAP files packed with zstd" "logs and MCAP files packed with zstd are not read")
slamicp_io_module(SQLITE sqlite3 "Read rosbag2 databases" "rosbag2 databases are not read")
slamicp_io_module(YAML yaml-cpp "Read rosbag2 folders, map_server maps and worlds" "rosbag2 folders, map_server maps and worlds are not read")
slamicp_io_package(CDR fastcdr fastcdr fastcdr "Read messages of ROS 2" "messages of ROS 2 are not read" 1)
