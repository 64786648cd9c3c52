# Windows, 64 bits, from Linux: MinGW-w64 with POSIX threads (Debian: g++-mingw-w64-x86-64-posix). Programs run under
# Wine (Debian: wine64).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# SLAMICP_TARGET_PREFIX: where more libraries for Windows are, built by hand or by scripts/package.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SLAMICP_TARGET_PREFIX)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 ${SLAMICP_TARGET_PREFIX})
include(${CMAKE_CURRENT_LIST_DIR}/find.cmake)

# The compiler's libraries go into our programs and DLLs: beside them nothing but Windows is needed.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)

find_program(SLAMICP_WINE NAMES wine64 wine PATHS /usr/lib/wine DOC "Runs Windows programs")
if(SLAMICP_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SLAMICP_WINE})
endif()
