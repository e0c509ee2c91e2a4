# SPDX-License-Identifier: MIT
# Sanitizers and coverage for all of our code.
if(GNOMON_SANITIZE)
  add_compile_options(-fsanitize=${GNOMON_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${GNOMON_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND GNOMON_SANITIZE MATCHES "undefined")
    # These four triple g++'s compile time on CGAL code; the clang preset has them all.
    add_compile_options(-fno-sanitize=null,alignment,vptr,object-size)
  endif()
endif()
option(GNOMON_COVERAGE "Count line coverage (gcov)" OFF)
if(GNOMON_COVERAGE)
  add_compile_options(--coverage -O1)
  add_link_options(--coverage)
endif()
