# SPDX-License-Identifier: MIT
# cmake --install: the command line (component tool), the MIT libraries scene and fast (component fast), and the GPL
# references (component exact, on top of fast). Consumers: find_package(gnomon COMPONENTS fast exact).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(gnomon_include ${CMAKE_INSTALL_INCLUDEDIR}/gnomon)
set(gnomon_package ${CMAKE_INSTALL_LIBDIR}/cmake/gnomon)
set(gnomon_doc ${CMAKE_INSTALL_DOCDIR})

# Headers that no consumer includes: those that say so, and the inner loops that are compiled once a SIMD target.
function(gnomon_install_headers folder component)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER headers EXCLUDE REGEX "_inl\\.h$")
  foreach(header IN LISTS headers)
    file(READ ${header} text)
    string(REGEX REPLACE "\n// *" " " text "${text}")
    if(NOT text MATCHES "Internal to ${folder}/")
      install(FILES ${header} DESTINATION ${gnomon_include}/${folder} COMPONENT ${component})
    endif()
  endforeach()
endfunction()

gnomon_install_headers(scene fast)
gnomon_install_headers(fast fast)
gnomon_install_headers(exact exact)

foreach(library scene fast exact)
  set_target_properties(gnomon_${library} PROPERTIES EXPORT_NAME ${library})
  target_compile_features(gnomon_${library} PUBLIC cxx_std_20)
endforeach()
install(TARGETS gnomon_scene gnomon_fast EXPORT gnomonFastTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT fast INCLUDES DESTINATION ${gnomon_include})
install(TARGETS gnomon_exact EXPORT gnomonExactTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT exact INCLUDES DESTINATION ${gnomon_include})
install(EXPORT gnomonFastTargets NAMESPACE gnomon:: DESTINATION ${gnomon_package} COMPONENT fast)
install(EXPORT gnomonExactTargets NAMESPACE gnomon:: DESTINATION ${gnomon_package} COMPONENT exact)

# What the static library fast links for itself, its consumers link too.
get_target_property(fast_links gnomon_fast LINK_LIBRARIES)
set(gnomon_fast_dependencies "")
if("hwy::hwy" IN_LIST fast_links)
  set(gnomon_fast_dependencies "find_dependency(hwy)")
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gnomonConfig.cmake.in
  ${PROJECT_BINARY_DIR}/gnomonConfig.cmake INSTALL_DESTINATION ${gnomon_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gnomonConfig.cmake ${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake
        DESTINATION ${gnomon_package} COMPONENT fast)

install(TARGETS gnomon RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool)
install(FILES README.md DESTINATION ${gnomon_doc} COMPONENT tool)
install(FILES LICENSES/MIT.txt DESTINATION ${gnomon_doc}/LICENSES COMPONENT fast)
foreach(component exact tool)
  install(FILES LICENSES/GPL-3.0-or-later.txt DESTINATION ${gnomon_doc}/LICENSES COMPONENT ${component})
endforeach()
