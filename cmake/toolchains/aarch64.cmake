# 64-bit ARM (ARMv8) with Linux, from another machine (Debian: g++-aarch64-linux-gnu). Programs run under QEMU (Debian:
# qemu-user).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # how GCC 10 changed its calls concerns nobody here
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SLAMICP_TARGET_PREFIX)
set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu ${SLAMICP_TARGET_PREFIX})
include(${CMAKE_CURRENT_LIST_DIR}/find.cmake)

find_program(SLAMICP_QEMU qemu-aarch64 DOC "Runs ARM programs")
if(SLAMICP_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SLAMICP_QEMU} -L /usr/aarch64-linux-gnu)
endif()
