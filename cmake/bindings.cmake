# Which other languages are served; the folder bindings may be missing, and nothing else notices.
set(SLAMICP_BINDINGS OFF)
if(EXISTS ${PROJECT_SOURCE_DIR}/bindings/CMakeLists.txt)
  set(SLAMICP_BINDINGS ON)
endif()
cmake_dependent_option(SLAMICP_BUILD_C "Build slamicp_c, the interface for C" ${PROJECT_IS_TOP_LEVEL}
  SLAMICP_BINDINGS OFF)
cmake_dependent_option(SLAMICP_BUILD_MATLAB "Build SLAMICP for Octave, where mkoctfile is found" ${PROJECT_IS_TOP_LEVEL}
  "SLAMICP_BUILD_C;NOT SLAMICP_SANITIZE;NOT CMAKE_CROSSCOMPILING" OFF)
cmake_dependent_option(SLAMICP_BUILD_PYTHON "Build the Python extension; pip does (pyproject.toml)" OFF
  "SLAMICP_BINDINGS;SLAMICP_BUILD_IO" OFF)
if(SLAMICP_BUILD_MATLAB)
  find_program(SLAMICP_MKOCTFILE mkoctfile DOC "Octave's compiler driver, which says where its headers are")
  find_program(SLAMICP_OCTAVE octave-cli DOC "Octave, for its tests")
endif()
