# SPDX-License-Identifier: MIT
# gnomon::warnings: what every target of ours is compiled with; errors in CI (presets set GNOMON_WERROR).
add_library(gnomon_warnings INTERFACE)
add_library(gnomon::warnings ALIAS gnomon_warnings)
target_compile_options(gnomon_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Woverloaded-virtual
  # g++ 12 warns of overlapping copies in std::string's own operator+ (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${GNOMON_WERROR}>:-Werror>)

# The folders are the modules: include paths are written from the root, e.g. "fast/shaft.h".
function(gnomon_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(gnomon_${name} STATIC ${sources})
  add_library(gnomon::${name} ALIAS gnomon_${name})
  target_include_directories(gnomon_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(gnomon_${name} PRIVATE $<BUILD_INTERFACE:gnomon::warnings>)
endfunction()
