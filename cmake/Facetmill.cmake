# Settings and helpers that every folder uses.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

set(FACETMILL_VTK_COMPONENTS
    CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms FiltersCore FiltersGeneral
    FiltersGeometry FiltersSources IOImage IOXML ImagingCore InteractionStyle InteractionWidgets RenderingAnnotation
    RenderingCore RenderingFreeType RenderingOpenGL2)

add_library(facetmill_options INTERFACE)
target_include_directories(facetmill_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(facetmill_options INTERFACE
    -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
    -Wno-missing-field-initializers # designated initializers name what they set
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds;-Wno-maybe-uninitialized> # false alarms of g++ 12 in std::string and std::variant
    $<$<BOOL:${CMAKE_UNITY_BUILD}>:$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>> # files compiled together keep what is their own
    -Werror
    -ffp-contract=off # the same bits whichever instruction set a kernel is compiled for
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288> # kB: the compiler collects its garbage a third as often
    # Tests and widgets call core, which is where the time goes: compiling them with less takes a third less time. (A precompiled
    # header brings its own level of optimization along, whatever the sources ask for: targets that share one share that.)
    $<$<CONFIG:Release>:$<IF:$<OR:$<BOOL:$<TARGET_PROPERTY:FACETMILL_CHECKED>>,$<BOOL:$<TARGET_PROPERTY:FACETMILL_TEST>>,$<BOOL:$<TARGET_PROPERTY:FACETMILL_LIGHT>>>,-O1,-O3>>)

# Every test is linked with all of core, which gold, of the same package as the compiler's own linker, does in a quarter of the
# time.
find_program(FACETMILL_GOLD ld.gold)
if(FACETMILL_GOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_link_options(facetmill_options INTERFACE -fuse-ld=gold)
endif()

# Null pointers and pointers beyond their object stop under the address sanitizer as well when they are used, and what is not
# aligned does no harm here, but these checks, one for every use of a pointer, make compiling half as long again. What the tests
# themselves do is checked for addresses alone.
set(FACETMILL_SANITIZE_OPTIONS -fno-sanitize=null,alignment,object-size,pointer-overflow
    $<$<BOOL:$<TARGET_PROPERTY:FACETMILL_TEST>>:-fno-sanitize=undefined> -fno-omit-frame-pointer -fno-sanitize-recover=all)
if(FACETMILL_SANITIZE)
    target_compile_options(facetmill_options INTERFACE -fsanitize=${FACETMILL_SANITIZE} ${FACETMILL_SANITIZE_OPTIONS})
    target_link_options(facetmill_options INTERFACE -fsanitize=${FACETMILL_SANITIZE})
endif()
# Targets with the property FACETMILL_CHECKED are compiled with sanitizers and assertions, in whichever configuration. Where
# FACETMILL_CHECKED_SCOPES asks for it, uses of a variable after its block has ended are looked for, a third of the compiler's time,
# and what is found is told with its line, a twelfth of it; else with its function.
target_compile_options(facetmill_options INTERFACE
    "$<$<AND:$<BOOL:$<TARGET_PROPERTY:FACETMILL_CHECKED>>,$<BOOL:${FACETMILL_CHECKED_SCOPES}>>:-g1>"
    "$<$<BOOL:$<TARGET_PROPERTY:FACETMILL_CHECKED>>:-UNDEBUG;-fsanitize=address,undefined;${FACETMILL_SANITIZE_OPTIONS}>"
    "$<$<AND:$<BOOL:$<TARGET_PROPERTY:FACETMILL_CHECKED>>,$<NOT:$<BOOL:${FACETMILL_CHECKED_SCOPES}>>>:-fno-sanitize-address-use-after-scope>")
target_link_options(facetmill_options INTERFACE
    "$<$<BOOL:$<TARGET_PROPERTY:FACETMILL_CHECKED>>:-fsanitize=address,undefined>")

# Rooms of core, each below the ones before it: a room includes only rooms to its left. Strategy has a room for each of
# its wings.
set(FACETMILL_ROOMS base mesh repair cutter setup tools gouge cspace
    strategy/plan strategy/surface strategy/five_axis strategy/tilt strategy/finish3 strategy/waterline strategy/scallop strategy/steep_shallow strategy/rough
    strategy/global_local strategy/cleanup strategy/curves strategy/lathe strategy/preview
    link verify output job study)

# The rooms that FACETMILL_CHECKED compiles under sanitizers every time: what reads what strangers send, and what reckons with
# places in memory by hand. The others hold what these make in vectors; they stand beside them as they ship, and come under
# sanitizers with FACETMILL_CHECKED_ALL.
set(FACETMILL_CHECKED_ROOMS base mesh repair cutter setup tools gouge cspace output)
if(FACETMILL_CHECKED_ALL)
    set(FACETMILL_CHECKED_ROOMS ${FACETMILL_ROOMS})
endif()

# facetmill_room(NAME SOURCES ...): one room of core. Object libraries: an operation that only registers itself would be
# dropped from a static one. With FACETMILL_SHARED_ROOMS each is a shared library, and a change in it links it alone again
# instead of all programs. With FACETMILL_CHECKED those of FACETMILL_CHECKED_ROOMS are compiled once more, under sanitizers, as
# fm_NAME_checked. The target rooms is all of them.
add_custom_target(rooms)
function(facetmill_room name)
    cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
    if(NOT ARG_SOURCES)
        return()
    endif()
    string(REPLACE "/" "_" target fm_${name})
    if(FACETMILL_SHARED_ROOMS)
        add_library(${target} SHARED ${ARG_SOURCES})
        set_target_properties(${target} PROPERTIES DEFINE_SYMBOL "") # one more would part it from the precompiled header
    else()
        add_library(${target} OBJECT ${ARG_SOURCES})
    endif()
    facetmill_compile_room(${name} ${target} "")
    add_dependencies(rooms ${target})
    if(FACETMILL_CHECKED AND name IN_LIST FACETMILL_CHECKED_ROOMS)
        add_library(${target}_checked OBJECT EXCLUDE_FROM_ALL ${ARG_SOURCES})
        set_target_properties(${target}_checked PROPERTIES FACETMILL_CHECKED TRUE)
        facetmill_compile_room(${name} ${target}_checked _checked)
        add_dependencies(rooms ${target}_checked)
    endif()
endfunction()

function(facetmill_compile_room name target variant)
    target_link_libraries(${target} PUBLIC facetmill_options Eigen3::Eigen TBB::tbb OpenMeshCore PkgConfig::ZIP PNG::PNG TIFF::TIFF EXPAT::EXPAT
        nlohmann_json::nlohmann_json Threads::Threads)
    # All rooms are compiled alike: the first makes the header of them all.
    list(GET FACETMILL_ROOMS 0 first)
    if(name STREQUAL first)
        target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/core_pch.h)
    else()
        target_precompile_headers(${target} REUSE_FROM fm_${first}${variant})
    endif()
endfunction()

# facetmill_rooms_up_to(RESULT ROOM): the room and all rooms before it; `strategy` means all of its wings.
function(facetmill_rooms_up_to result upto)
    set(found FALSE)
    set(rooms "")
    foreach(room IN LISTS FACETMILL_ROOMS)
        set(inside FALSE)
        if(room STREQUAL upto OR room MATCHES "^${upto}/")
            set(inside TRUE)
            set(found TRUE)
        endif()
        if(found AND NOT inside)
            break()
        endif()
        list(APPEND rooms ${room})
    endforeach()
    if(NOT found)
        message(FATAL_ERROR "there is no room ${upto}")
    endif()
    set(${result} ${rooms} PARENT_SCOPE)
endfunction()

# facetmill_link_core(TARGET ROOM): links the room and all rooms before it.
function(facetmill_link_core target upto)
    facetmill_rooms_up_to(rooms ${upto})
    facetmill_link_rooms(${target} ${rooms})
endfunction()

# facetmill_link_rooms(TARGET room ...): links these rooms and no others: what they need of another does not link.
function(facetmill_link_rooms target)
    facetmill_link_rooms_of("" ${target} ${ARGN})
endfunction()

# The same with the rooms' VARIANT: none, or _checked, which not every room has.
function(facetmill_link_rooms_of variant target)
    foreach(room IN LISTS ARGN)
        string(REPLACE "/" "_" library fm_${room}${variant})
        if(NOT TARGET ${library})
            string(REPLACE "/" "_" library fm_${room})
        endif()
        if(TARGET ${library} AND FACETMILL_SHARED_ROOMS)
            # Needed even where nothing calls it: operations register themselves.
            target_link_libraries(${target} PRIVATE "-Wl,--push-state,--no-as-needed" ${library} "-Wl,--pop-state")
            set_target_properties(${target} PROPERTIES LINK_DEPENDS_NO_SHARED TRUE)
        elseif(TARGET ${library})
            target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
        endif()
    endforeach()
    target_link_libraries(${target} PRIVATE facetmill_options Eigen3::Eigen TBB::tbb OpenMeshCore PkgConfig::ZIP PNG::PNG TIFF::TIFF EXPAT::EXPAT
        nlohmann_json::nlohmann_json Threads::Threads)
endfunction()

# facetmill_reuse_core_header(TARGET): a program without Qt takes the rooms' precompiled header, for which it has to be compiled as
# they are: position independent as a library's code is.
function(facetmill_reuse_core_header target)
    list(GET FACETMILL_ROOMS 0 first)
    target_compile_options(${target} PRIVATE -fPIC)
    target_precompile_headers(${target} REUSE_FROM fm_${first})
endfunction()

# Tests give way to those of the windows, which wait for what is drawn more than they compute.
find_program(FACETMILL_NICE nice)
if(FACETMILL_NICE)
    set(FACETMILL_NICE ${FACETMILL_NICE} -n 10)
else()
    set(FACETMILL_NICE "")
endif()

# A slow machine is limited by the TIMEOUT of a test alone: QtTest would end every function that runs for 5 minutes.
set(FACETMILL_TEST_TIMEOUT 1800)
set(FACETMILL_TEST_ENVIRONMENT QTEST_FUNCTION_TIMEOUT=1800000) # ms

# facetmill_run_moc(TARGET READ MADE): runs moc as a source of the target, in one short command, where AUTOMOC takes seconds per
# target to look for them. It is told the target's definitions, or it would not see slots that stand under one of them, but no
# folders: what a class declares stands in the file itself, and headers of Qt take it fifty times as long.
function(facetmill_run_moc target read made)
    set(definitions "$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>")
    cmake_path(ABSOLUTE_PATH read BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    add_custom_command(OUTPUT ${made} DEPENDS ${read} VERBATIM COMMAND_EXPAND_LISTS
        COMMAND Qt6::moc "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" ${ARGN} -o ${made} ${read})
    target_sources(${target} PRIVATE ${made})
endfunction()

# facetmill_moc(TARGET SOURCES ...): for the sources that include their .moc.
function(facetmill_moc target)
    foreach(source IN LISTS ARGN)
        cmake_path(GET source STEM stem)
        file(STRINGS ${source} included REGEX "^#include \"${stem}\\.moc\"")
        if(included)
            facetmill_run_moc(${target} ${source} ${CMAKE_CURRENT_BINARY_DIR}/${stem}.moc)
        endif()
    endforeach()
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

# facetmill_moc_headers(TARGET FOLDER SOURCES ...): for the headers of the sources that declare anything to moc; FOLDER: from the root.
function(facetmill_moc_headers target folder)
    foreach(source IN LISTS ARGN)
        cmake_path(GET source STEM stem)
        if(source MATCHES "\\.cpp$" AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${stem}.h)
            file(STRINGS ${stem}.h objects REGEX "^ *(Q_OBJECT|Q_NAMESPACE|Q_GADGET)")
            if(objects)
                facetmill_run_moc(${target} ${stem}.h ${CMAKE_CURRENT_BINARY_DIR}/moc_${stem}.cpp -f ${folder}/${stem}.h)
            endif()
        endif()
    endforeach()
endfunction()

# facetmill_test_classes(RESULT SOURCES ...): the classes that register themselves in these sources.
function(facetmill_test_classes result)
    set(classes "")
    foreach(source IN LISTS ARGN)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
        file(STRINGS ${source} lines REGEX "^FACETMILL_TEST\\(")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^FACETMILL_TEST\\(([A-Za-z0-9_]+)\\).*" "\\1" class "${line}")
            list(APPEND classes ${class})
        endforeach()
    endforeach()
    set(${result} ${classes} PARENT_SCOPE)
endfunction()

# facetmill_test_program(PROGRAM VARIANT room ...): a program for tests, with the rooms' VARIANT: "" or _checked.
function(facetmill_test_program program variant)
    # Rooms first: where both have an inlined function the linker takes that of the room, as it is compiled.
    add_executable(${program})
    facetmill_link_rooms_of("${variant}" ${program} ${ARGN})
    target_link_libraries(${program} PRIVATE facetmill_test_support Qt6::Core Qt6::Test)
    set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX)
    if(variant)
        set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL TRUE FACETMILL_CHECKED TRUE)
    endif()
endfunction()

# facetmill_test_objects(TARGET SOURCES ...): compiles these sources of tests, and those of further calls with them.
function(facetmill_test_objects target)
    if(NOT TARGET ${target})
        add_library(${target} OBJECT)
        set_target_properties(${target} PROPERTIES FACETMILL_TEST TRUE)
        target_link_libraries(${target} PRIVATE facetmill_options Eigen3::Eigen TBB::tbb OpenMeshCore PkgConfig::ZIP PNG::PNG TIFF::TIFF EXPAT::EXPAT
            nlohmann_json::nlohmann_json Threads::Threads facetmill_qt_test)
        target_compile_definitions(${target} PRIVATE FACETMILL_TEST_DATA="${PROJECT_SOURCE_DIR}/tests")
        target_precompile_headers(${target} REUSE_FROM facetmill_test_header)
    endif()
    target_sources(${target} PRIVATE ${ARGN})
    facetmill_moc(${target} ${ARGN})
endfunction()

# facetmill_test(NAME ROOM room | ROOMS room ... [LABELS ...] [TIMEOUT s] [COST n] [ALL_CASES] [CHECKED_APART] SOURCES ...): a
# QtTest program whose classes register themselves with FACETMILL_TEST (tests/support/test_runner.h), linked with ROOM and all
# rooms before it or with ROOMS alone. Those without a label are the target unit_tests, and with FACETMILL_CHECKED each of them is
# run once more, as NAME_checked, with the rooms under sanitizers: by the program checked_tests, which has the classes of all of
# them, since linking such rooms takes longest; CHECKED_APART: by one of its own, which that target brings along. Programs of higher
# cost are run first, so that no processor idles while the longest one ends. ALL_CASES: it tries a part of its cases, and all of
# them in the slow tests, as NAME_all_cases. Those that are labelled slow are built where benchmarks are. WITH name: its sources are
# compiled together with those of the other tests of the folder that say the same, since headers take longer than what a test adds
# to them; each of the programs, all with the same rooms, has the classes of all, and runs its own.
function(facetmill_test name)
    cmake_parse_arguments(ARG "ALL_CASES;CHECKED_APART" "ROOM;TIMEOUT;COST;WITH" "ROOMS;SOURCES;LABELS" ${ARGN})
    if(ARG_ROOM)
        facetmill_rooms_up_to(ARG_ROOMS ${ARG_ROOM})
    endif()
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT ${FACETMILL_TEST_TIMEOUT})
    endif()
    if(NOT ARG_COST)
        set(ARG_COST 0)
    endif()
    set(objects ${name}_objects)
    if(ARG_WITH)
        set(objects ${ARG_WITH}_objects)
    endif()
    facetmill_test_objects(${objects} ${ARG_SOURCES})

    facetmill_test_program(${name} "" ${ARG_ROOMS})
    facetmill_test_classes(classes ${ARG_SOURCES})
    list(JOIN classes "," classes)
    if(ARG_WITH)
        set(own ${CMAKE_CURRENT_BINARY_DIR}/${name}_classes.cpp)
        file(CONFIGURE OUTPUT ${own} CONTENT "namespace facetmill::test {\nextern const char* const own_classes;\nconst char* const own_classes = \"${classes}\";\n} // namespace facetmill::test\n")
        target_sources(${name} PRIVATE ${own})
    endif()
    set(tests ${name})
    list(GET ARG_ROOMS -1 tested)
    if(FACETMILL_CHECKED AND NOT ARG_LABELS AND tested IN_LIST FACETMILL_CHECKED_ROOMS)
        list(APPEND tests ${name}_checked)
        if(ARG_CHECKED_APART)
            facetmill_test_program(${name}_checked _checked ${ARG_ROOMS})
            add_dependencies(checked_tests ${name}_checked)
        endif()
    endif()
    foreach(test IN LISTS tests)
        set(program ${test})
        set(environment ${FACETMILL_TEST_ENVIRONMENT})
        if(NOT TARGET ${test})
            set(program checked_tests)
            list(APPEND environment FACETMILL_CLASSES=${classes})
        endif()
        get_target_property(has ${program} FACETMILL_OBJECTS)
        if(NOT objects IN_LIST has) # checked_tests has them by another test of the same WITH
            set_property(TARGET ${program} APPEND PROPERTY FACETMILL_OBJECTS ${objects})
            target_sources(${program} PRIVATE $<TARGET_OBJECTS:${objects}>)
        endif()
        add_test(NAME ${test} COMMAND ${FACETMILL_NICE} $<TARGET_FILE:${program}>)
        set_tests_properties(${test} PROPERTIES TIMEOUT ${ARG_TIMEOUT} COST ${ARG_COST} LABELS "${ARG_LABELS}"
            ENVIRONMENT "${environment}")
    endforeach()
    if(TEST ${name}_checked)
        # Freed memory is looked after until 32 MB more were freed, not 256: fetching other memory meanwhile took a quarter of the time.
        # Four calls of where memory came from are kept, not thirty: a sixth of the time.
        set_tests_properties(${name}_checked PROPERTIES LABELS checked)
        set_property(TEST ${name}_checked APPEND PROPERTY ENVIRONMENT ASAN_OPTIONS=quarantine_size_mb=32:malloc_context_size=4)
    endif()
    if(ARG_ALL_CASES)
        add_test(NAME ${name}_all_cases COMMAND ${FACETMILL_NICE} $<TARGET_FILE:${name}>)
        set_tests_properties(${name}_all_cases PROPERTIES TIMEOUT 7200 LABELS slow
            ENVIRONMENT "QTEST_FUNCTION_TIMEOUT=7200000;FACETMILL_ALL_CASES=1")
    endif()
    if(NOT ARG_LABELS)
        add_dependencies(unit_tests ${name})
    elseif("slow" IN_LIST ARG_LABELS AND NOT FACETMILL_BENCH_IN_ALL)
        set_target_properties(${name} ${objects} PROPERTIES EXCLUDE_FROM_ALL TRUE)
    endif()
endfunction()
