# Debian packages by CPack (preset packages, scripts/package): the shared libraries, by their SONAME; what is built
# against them, static libraries too; the command; Python. What goes where: docs/packages.md.
set(CMAKE_SKIP_INSTALL_RPATH ON)  # they go where the loader looks
set(debian ${PROJECT_SOURCE_DIR}/packaging/debian)
set(library_package libslamicp${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(library_c_package libslamicp-c1)
set(component_packages
  library=${library_package} library_c=${library_c_package} dev=libslamicp-dev tools=slamicp-tools python=python3-slamicp)

file(STRINGS ${debian}/changelog newest LIMIT_COUNT 1)
if(NOT newest MATCHES "^slamicp \\(([0-9.]+)-([0-9]+)\\)" OR NOT CMAKE_MATCH_1 VERSION_EQUAL PROJECT_VERSION)
  message(FATAL_ERROR "packaging/debian/changelog begins with '${newest}', but this is version ${PROJECT_VERSION}")
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE ${CMAKE_MATCH_2})
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION})
set(exactly "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# Static libraries of the same objects, for those who ask for them: pkg-config --static.
foreach(name core io c)
  if(TARGET slamicp_${name})
    set(objects $<TARGET_OBJECTS:slamicp_${name}>)
    if(name STREQUAL "c")
      set(objects $<TARGET_OBJECTS:slamicp_c_objects>)
    endif()
    add_library(slamicp_${name}_archive STATIC ${objects})
    set_target_properties(slamicp_${name}_archive PROPERTIES OUTPUT_NAME slamicp_${name} LINKER_LANGUAGE CXX
      ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/static)
    install(TARGETS slamicp_${name}_archive ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  endif()
endforeach()

# The manual: a page for the command and one for each verb, from what it says of itself.
find_program(SLAMICP_HELP2MAN help2man REQUIRED)
set(verbs demo info convert simulate map localize align odometry evaluate experiment)
set(pages "")
foreach(verb "" ${verbs})
  set(name slamicp)
  set(what "localize a lidar in its map, and get what the map does not know")
  if(verb)
    set(name slamicp-${verb})
    set(what "a verb of slamicp: see slamicp help")
  endif()
  set(page ${PROJECT_BINARY_DIR}/man/${name}.1)
  add_custom_command(OUTPUT ${page}.gz
    COMMAND ${SLAMICP_HELP2MAN} --no-info --no-discard-stderr --section=1 --name=${what}
      --version-string=${PROJECT_VERSION} "--source=slamicp ${PROJECT_VERSION}" --output=${page}
      "$<TARGET_FILE:slamicp_command> ${verb}"
    COMMAND sed -i "s/^slamicp ${verb} /${name} /" ${page}
    COMMAND gzip -9nf ${page}
    DEPENDS slamicp_command VERBATIM)
  list(APPEND pages ${page}.gz)
endforeach()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/man)
add_custom_target(slamicp_man ALL DEPENDS ${pages})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)

# SLAMICP_PYTHON_PACKAGE: a folder with what the wheel holds (scripts/package unpacks it).
set(SLAMICP_PYTHON_PACKAGE "" CACHE PATH "Where the wheel was unpacked, for python3-slamicp")
if(SLAMICP_PYTHON_PACKAGE)
  install(DIRECTORY ${SLAMICP_PYTHON_PACKAGE}/ DESTINATION lib/python3/dist-packages COMPONENT python
    USE_SOURCE_PERMISSIONS PATTERN *.data EXCLUDE PATTERN RECORD EXCLUDE PATTERN licenses EXCLUDE)
else()
  list(REMOVE_ITEM component_packages python=python3-slamicp)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "slamicp maintainers <maintainers@slamicp.example>")
set(CPACK_PACKAGE_NAME slamicp)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_SOURCE_DIR}/build/packages-out)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src ${PROJECT_BINARY_DIR}/bindings/c)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/debian)
configure_file(${debian}/changelog ${PROJECT_BINARY_DIR}/debian/changelog.Debian COPYONLY)
execute_process(COMMAND gzip -9nk -f ${PROJECT_BINARY_DIR}/debian/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
foreach(pair IN LISTS component_packages)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  install(FILES ${debian}/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz
    DESTINATION share/doc/${package} COMPONENT ${component})
endforeach()

# CPack puts the project's description before, as the synopsis.
set(what_it_is "slamicp tells a mobile robot where it is in its map, how sure it is, and what
stands there that the map does not know, all from one ICP match.
.
")
# dpkg's trigger, which lintian misses beside CPack's scripts.
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
foreach(upper LIBRARY LIBRARY_C)
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
endforeach()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "${what_it_is}These are the C++ libraries: the core, and the readers and writers of files.")
set(CPACK_DEBIAN_LIBRARY_C_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_C_PACKAGE_DEPENDS "${library_package} ${exactly}")
set(CPACK_DEBIAN_LIBRARY_C_DESCRIPTION "${what_it_is}This is the library for C, slamicp.h, whose interface stays.")
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "${library_package} ${exactly}, ${library_c_package} ${exactly}, libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libcairo2-dev, libpng-dev, liblz4-dev, libbz2-dev, zlib1g-dev, liblzma-dev, \
libzstd-dev, libyaml-cpp-dev, libsqlite3-dev, libfastcdr-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "${what_it_is}These are the headers for C++ and C, the static libraries, and what CMake and
pkg-config need. Whoever links slamicp-io statically needs what is suggested.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${library_package} ${exactly}")
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "${what_it_is}This is the command slamicp: maps, localizes, simulates, converts, evaluates.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${what_it_is}This is the module slamicp; it takes and gives NumPy arrays.")
find_package(Python3 COMPONENTS Interpreter)
math(EXPR next "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
include(CPack)
