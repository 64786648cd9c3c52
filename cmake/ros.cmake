# The nodes that robots run; the folder ros may be missing, and nothing else notices.
set(SLAMICP_ROS OFF)
if(EXISTS ${PROJECT_SOURCE_DIR}/ros/CMakeLists.txt)
  set(SLAMICP_ROS ON)
endif()
cmake_dependent_option(SLAMICP_BUILD_NODE_CORE "Build slamicp::node_core, the localization node without ROS"
  ${PROJECT_IS_TOP_LEVEL} "SLAMICP_ROS;SLAMICP_BUILD_IO;NOT SLAMICP_SANITIZE MATCHES thread" OFF)
cmake_dependent_option(SLAMICP_BUILD_ROS "Build the node for ROS 1, where roscpp is found" ${PROJECT_IS_TOP_LEVEL}
  "SLAMICP_BUILD_NODE_CORE;NOT SLAMICP_SANITIZE;NOT CMAKE_CROSSCOMPILING" OFF)
cmake_dependent_option(SLAMICP_BUILD_DDS "Build the node for ROS 2 machines, where Cyclone DDS is found"
  ${PROJECT_IS_TOP_LEVEL}
  "SLAMICP_BUILD_NODE_CORE;NOT SLAMICP_SANITIZE;NOT CMAKE_CROSSCOMPILING;NOT SLAMICP_PACKAGES" OFF)
