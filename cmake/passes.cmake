# The match in the plane, compiled once for each instruction set of the target's processor (src/registration/pass).
# Highway's headers are used to build these files, privately: nothing to link, nothing in our headers. Without them the
# library works one point at a time.
option(SLAMICP_WITH_HIGHWAY "Vectorize the match in the plane, where Highway's headers are found" ON)

function(slamicp_add_passes target)
  if(NOT SLAMICP_WITH_HIGHWAY)
    return()
  endif()
  if(CMAKE_CROSSCOMPILING AND EXISTS /usr/include/hwy/highway.h)
    slamicp_headers_for_target(SLAMICP_HIGHWAY_INCLUDE hwy)
  endif()
  find_path(SLAMICP_HIGHWAY_INCLUDE hwy/highway.h)
  if(NOT SLAMICP_HIGHWAY_INCLUDE)
    message(STATUS "slamicp: Highway not found (Debian: libhwy-dev), matches are computed one point at a time")
    return()
  endif()
  set(sets portable)
  set(in_our_order -ffp-contract=off)
  if(MSVC)
    set(in_our_order "")  # /fp:precise keeps it; which of the sets below a machine has, we ask GCC's way
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    list(APPEND sets sse4 avx2 avx512)
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
    list(APPEND sets neon)
  endif()
  set(highway_portable HWY_COMPILE_ONLY_SCALAR)
  set(flags_sse4 -march=x86-64-v2)
  set(flags_avx2 -march=x86-64-v3)
  set(flags_avx512 -march=x86-64-v4)
  foreach(set IN LISTS sets)
    if(NOT DEFINED highway_${set})
      set(highway_${set} HWY_COMPILE_ONLY_STATIC)
    endif()
    set(source ${PROJECT_SOURCE_DIR}/src/registration/pass/${set}.cpp)
    string(TOUPPER ${set} name)
    target_sources(${target} PRIVATE ${source})
    target_compile_definitions(${target} PRIVATE SLAMICP_PASS_${name}=1)
    # Old machines must not meet AVX in functions that the linker picked from here: see passes-inl.hpp. The passes are
    # sums over floats, whose order is ours: contraction into FMA is too.
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES
      COMPILE_OPTIONS "${flags_${set}};${in_our_order}"
      COMPILE_DEFINITIONS "${highway_${set}};HWY_DISABLE_PCLMUL_AES"
      INCLUDE_DIRECTORIES ""
      SKIP_PRECOMPILE_HEADERS ON)
  endforeach()
  target_include_directories(${target} SYSTEM PRIVATE ${SLAMICP_HIGHWAY_INCLUDE})
endfunction()
