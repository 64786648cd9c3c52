# Tests of a build for another machine, run by what CMAKE_CROSSCOMPILING_EMULATOR names: Wine, QEMU. The label says
# which: windows or arm64.
enable_language(C)
set(gtest_force_shared_crt ON CACHE INTERNAL "")
set(BUILD_GMOCK OFF CACHE INTERNAL "")
set(INSTALL_GTEST OFF CACHE INTERNAL "")
# Debian's sources of GoogleTest (libgtest-dev brings them along): there is no build of it for other machines.
add_subdirectory(/usr/src/googletest ${CMAKE_CURRENT_BINARY_DIR}/googletest EXCLUDE_FROM_ALL)

set(label arm64)
if(WIN32)
  set(label windows)
endif()
set(SLAMICP_CROSS_LABEL ${label} CACHE INTERNAL "The label of all these tests")
add_custom_target(slamicp_cross_tests)
# The library is compiled as users get it, the tests as is quickest.
target_compile_options(gtest PRIVATE -O0)
set(SLAMICP_TEST_OPTIONS -O1)

# slamicp_cross_test(PROGRAM LABEL [ARGUMENT...])
function(slamicp_cross_test program label)
  add_test(NAME ${program} COMMAND ${program} ${ARGN})
  set_tests_properties(${program} PROPERTIES LABELS "${SLAMICP_CROSS_LABEL};${label}" TIMEOUT 600)
  add_dependencies(slamicp_cross_tests ${program})
endfunction()
