# Core as one shared library with its headers, for programs of others: what `cmake --install` puts down.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The public headers are those of the table in core/README.md.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/README.md)
file(STRINGS ${PROJECT_SOURCE_DIR}/core/README.md rows REGEX "^\\| `core/[a-z0-9_/]+\\.h` \\|")
set(FACETMILL_PUBLIC_HEADERS "")
foreach(row IN LISTS rows)
    string(REGEX REPLACE "^\\| `([^`]+)`.*" "\\1" header "${row}")
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${header})
        message(FATAL_ERROR "core/README.md: there is no public header ${header}")
    endif()
    list(APPEND FACETMILL_PUBLIC_HEADERS ${header})
endforeach()

# facetmill_included(RESULT HEADERS ...): the headers and all files of core that they include, also through others.
function(facetmill_included result)
    set(waiting ${ARGN})
    set(seen "")
    while(waiting)
        list(POP_FRONT waiting header)
        if(header IN_LIST seen)
            continue()
        endif()
        list(APPEND seen ${header})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
        file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"core/")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
            list(APPEND waiting ${included})
        endforeach()
    endwhile()
    list(SORT seen)
    set(${result} ${seen} PARENT_SCOPE)
endfunction()

# Shared, so that operations that only register themselves are in it.
add_library(facetmill_core SHARED)
facetmill_link_core(facetmill_core study)
target_link_libraries(facetmill_core PUBLIC Eigen3::Eigen)
target_compile_features(facetmill_core PUBLIC cxx_std_20)
target_include_directories(facetmill_core INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/facetmill>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
target_link_options(facetmill_core PRIVATE LINKER:-Bsymbolic-functions)
set_target_properties(facetmill_core PROPERTIES EXPORT_NAME core VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} LINKER_LANGUAGE CXX)

install(TARGETS facetmill_core EXPORT FacetmillTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
facetmill_included(installed ${FACETMILL_PUBLIC_HEADERS})
foreach(header IN LISTS installed)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/facetmill/${folder})
endforeach()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Facetmill)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/FacetmillConfig.cmake.in
    ${PROJECT_BINARY_DIR}/generated/FacetmillConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/FacetmillConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/FacetmillConfig.cmake
    ${PROJECT_BINARY_DIR}/generated/FacetmillConfigVersion.cmake DESTINATION ${config_folder})
install(EXPORT FacetmillTargets NAMESPACE Facetmill:: DESTINATION ${config_folder})

file(RELATIVE_PATH relative_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" relative_prefix "${relative_prefix}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/facetmill.pc.in ${PROJECT_BINARY_DIR}/generated/facetmill.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/facetmill.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
