# The compiler settings that every target of the project shares.
add_library(slamicp_settings INTERFACE)
target_compile_features(slamicp_settings INTERFACE cxx_std_20)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(slamicp_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  # Where processors multiply and add in one step, the same expression would have other last bits in each place that it is
  # compiled in: an index would not be brute force's equal, nor ARM's answers x86's. (Plain x86-64 has no such step.)
  target_compile_options(slamicp_settings INTERFACE -ffp-contract=off)
  if(SLAMICP_WERROR)
    target_compile_options(slamicp_settings INTERFACE -Werror)
  endif()
  if(SLAMICP_SANITIZE)
    target_compile_options(slamicp_settings INTERFACE
      -fsanitize=${SLAMICP_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(slamicp_settings INTERFACE -fsanitize=${SLAMICP_SANITIZE})
  endif()
elseif(MSVC)
  target_compile_options(slamicp_settings INTERFACE /W4 /utf-8 $<$<BOOL:${SLAMICP_WERROR}>:/WX>)
endif()

# slamicp_precompile(TARGET): what most of our sources begin with is read once, where that is asked for. Elsewhere each
# source shows that it includes what it uses.
function(slamicp_precompile target)
  if(SLAMICP_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU>
      <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <sstream> <string> <vector>)
  endif()
endfunction()

# slamicp_settings_for(TARGET): warnings and sanitizers for our own sources, not for those who link us.
function(slamicp_settings_for target)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:slamicp_settings>)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF WINDOWS_EXPORT_ALL_SYMBOLS ON)
endfunction()
