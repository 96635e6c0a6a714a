# The manual: pages made of resources/manual, the glossary and the reference, which are installed and compiled into the workbench.
set(manual_tool ${PROJECT_SOURCE_DIR}/app/manual)
set(FACETMILL_MANUAL_SOURCES ${manual_tool}/markdown.cpp ${manual_tool}/pages.cpp ${manual_tool}/words.cpp)
add_executable(make_manual ${manual_tool}/make_manual.cpp ${FACETMILL_MANUAL_SOURCES})
facetmill_link_rooms(make_manual base)
facetmill_reuse_core_header(make_manual)

set(resources ${PROJECT_SOURCE_DIR}/resources)
file(GLOB manual_sources CONFIGURE_DEPENDS ${resources}/manual/* ${resources}/manual/*/* ${resources}/languages/*.ts ${resources}/drawings/* ${resources}/pictures/manual/*.png ${resources}/pictures/manual/*/*.png)
set(FACETMILL_MANUAL ${PROJECT_BINARY_DIR}/manual)
# Files that say the same stay as they are: the stamp tells the build that it has looked.
add_custom_command(OUTPUT ${FACETMILL_MANUAL}.stamp VERBATIM
    COMMAND make_manual ${resources} ${FACETMILL_MANUAL}
    COMMAND ${CMAKE_COMMAND} -E touch ${FACETMILL_MANUAL}.stamp
    DEPENDS make_manual ${manual_sources} ${resources}/glossary.md ${resources}/reference.md
    COMMENT "Making the manual")
add_custom_target(manual ALL DEPENDS ${FACETMILL_MANUAL}.stamp)

include(GNUInstallDirs)
install(DIRECTORY ${FACETMILL_MANUAL}/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/manual OPTIONAL
    FILES_MATCHING PATTERN "*.html" PATTERN "*.css" PATTERN "*.png" PATTERN "*.svg")
