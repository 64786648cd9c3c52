# `cmake --install`: headers, libraries, the command, and how others find them: find_package(slamicp) gives
# slamicp::core, find_package(slamicp COMPONENTS io) slamicp::io as well, find_package(slamicp COMPONENTS c) slamicp::c alone;
# pkg-config slamicp-core, slamicp-io, slamicp-c.
# What is installed may be moved: nothing in it names the prefix.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/slamicp)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(headers_not_built "")
if(NOT SLAMICP_BUILD_IO)
  set(headers_not_built PATTERN io EXCLUDE)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/slamicp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT dev FILES_MATCHING PATTERN *.hpp ${headers_not_built})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# slamicp_install_library(core REQUIRES eigen3 ...): the target slamicp_core, its package part, its pkg-config file.
function(slamicp_install_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "COMPONENT;DESCRIPTION" "REQUIRES;REQUIRES_PRIVATE;LIBS_PRIVATE")
  install(TARGETS slamicp_${name} EXPORT slamicp-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${arg_COMPONENT} NAMELINK_COMPONENT dev
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${arg_COMPONENT})
  install(EXPORT slamicp-${name} NAMESPACE slamicp:: FILE slamicp-${name}-targets.cmake DESTINATION ${package_dir}
    COMPONENT dev)

  # A static library hands its private needs on to whoever links it. Beside a shared one they are libraries alone, for
  # pkg-config --static: as modules pkg-config would ask everybody for their headers.
  list(TRANSFORM arg_LIBS_PRIVATE PREPEND -l)
  if(BUILD_SHARED_LIBS)
    foreach(module IN LISTS arg_REQUIRES_PRIVATE)
      list(TRANSFORM ${module}_LIBRARIES PREPEND -l OUTPUT_VARIABLE libraries)
      list(APPEND arg_LIBS_PRIVATE ${libraries})
    endforeach()
  else()
    list(APPEND arg_REQUIRES ${arg_REQUIRES_PRIVATE})
  endif()
  set(arg_REQUIRES_PRIVATE "")
  list(JOIN arg_LIBS_PRIVATE " " pc_libs_private)
  set(pc_libs "")
  if(NOT BUILD_SHARED_LIBS)
    set(pc_libs ${pc_libs_private})
    set(pc_libs_private "")
  endif()
  list(JOIN arg_REQUIRES " " pc_requires)
  list(JOIN arg_REQUIRES_PRIVATE " " pc_requires_private)
  set(pc_name slamicp-${name})
  set(pc_description ${arg_DESCRIPTION})
  set(pc_library slamicp_${name})
  file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY "\${prefix}" OUTPUT_VARIABLE pc_libdir)
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY "\${prefix}" OUTPUT_VARIABLE pc_includedir)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/slamicp.pc.in ${PROJECT_BINARY_DIR}/slamicp-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/slamicp-${name}.pc DESTINATION ${pkgconfig_dir} COMPONENT dev)
endfunction()

slamicp_install_library(core COMPONENT library REQUIRES eigen3 DESCRIPTION "${PROJECT_DESCRIPTION}")
if(SLAMICP_BUILD_IO)
  slamicp_install_library(io COMPONENT library REQUIRES slamicp-core REQUIRES_PRIVATE ${SLAMICP_IO_MODULES}
    LIBS_PRIVATE ${SLAMICP_IO_LIBRARIES} DESCRIPTION "Files and pictures for slamicp-core")
endif()
if(TARGET slamicp_c)
  install(FILES ${PROJECT_SOURCE_DIR}/bindings/c/include/slamicp.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  slamicp_install_library(c COMPONENT library_c DESCRIPTION "slamicp's interface for C: a shared library that needs nothing")
endif()
if(TARGET slamicp_command)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(slamicp_command PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  install(TARGETS slamicp_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/slamicp-config.cmake.in
  ${PROJECT_BINARY_DIR}/slamicp-config.cmake INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slamicp-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slamicp-config.cmake ${PROJECT_BINARY_DIR}/slamicp-config-version.cmake
  DESTINATION ${package_dir} COMPONENT dev)
