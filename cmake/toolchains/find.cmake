# What is looked for when the target is not this machine: programs here, libraries and packages there. Libraries that
# are headers only are this machine's; cmake/header_only.cmake keeps the compiler from the rest of /usr/include.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(Eigen3_DIR /usr/share/eigen3/cmake)
set(CLI11_DIR /usr/share/cmake/CLI11)
set(nlohmann_json_DIR /usr/share/cmake/nlohmann_json)

list(TRANSFORM CMAKE_FIND_ROOT_PATH APPEND /lib/pkgconfig OUTPUT_VARIABLE modules)
list(JOIN modules ":" modules)
set(ENV{PKG_CONFIG_LIBDIR} "${modules}")
