# 32-bit ARM (ARMv7, hard float) with Linux: to see that all compiles. clang needs no more than the headers (Debian:
# libstdc++-12-dev-armhf-cross).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET arm-linux-gnueabihf)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH /usr/arm-linux-gnueabihf)
include(${CMAKE_CURRENT_LIST_DIR}/find.cmake)
