# Helpers that make one library of each room and one test program of each test folder.

add_library(lacuna_options INTERFACE)
target_include_directories(lacuna_options INTERFACE ${CMAKE_SOURCE_DIR})
# -Wrestrict: GCC 12 sees overlaps in "text" + std::string that are not there (GCC bug 105651).
target_compile_options(lacuna_options INTERFACE -Wall -Wextra -Wshadow -Wno-unused-parameter -Wno-restrict)
option(LACUNA_WERROR "Treat warnings as errors" OFF)
if(LACUNA_WERROR)
    target_compile_options(lacuna_options INTERFACE -Werror)
endif()
target_link_libraries(lacuna_options INTERFACE Threads::Threads)
set(LACUNA_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined or thread")
if(LACUNA_SANITIZE)
    # vptr needs type information that DCMTK's and ITK's libraries do not export.
    set(sanitize -fsanitize=${LACUNA_SANITIZE} -fno-sanitize=vptr -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(lacuna_options INTERFACE ${sanitize})
    target_link_options(lacuna_options INTERFACE ${sanitize})
endif()
# The test programs that are worth running under a sanitizer (./test does): label and target of the same name.
set(LACUNA_SANITIZED_TESTS test_base test_volume test_classify test_regions test_io test_render)
add_custom_target(sanitized_tests)

# lacuna_room(NAME DEPENDS lacuna_x ... LIBRARIES other ...): static library lacuna_NAME of all .cpp files in this folder.
function(lacuna_room name)
    cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.h)
    set(compiled ${sources})
    list(FILTER compiled INCLUDE REGEX "\\.cpp$")
    if(NOT compiled)  # headers only
        add_library(lacuna_${name} INTERFACE)
        target_link_libraries(lacuna_${name} INTERFACE lacuna_options ${ARG_DEPENDS} ${ARG_LIBRARIES})
        return()
    endif()
    add_library(lacuna_${name} STATIC ${sources})
    set_target_properties(lacuna_${name} PROPERTIES LINKER_LANGUAGE CXX)
    target_link_libraries(lacuna_${name} PUBLIC lacuna_options ${ARG_DEPENDS} ${ARG_LIBRARIES}
                                         PRIVATE ${ARG_PRIVATE_LIBRARIES})
endfunction()

# lacuna_tests(test_ROOM DEPENDS ... [LABEL label]): test program of all *_test.cpp in this folder, one CTest case named
# ROOM.Suite.Case a GoogleTest case.
function(lacuna_tests name)
    cmake_parse_arguments(ARG "" "LABEL" "DEPENDS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS *_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE LACUNA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    set(label unit)
    if(ARG_LABEL)
        set(label ${ARG_LABEL})
    endif()
    if(name IN_LIST LACUNA_SANITIZED_TESTS)
        set(label sanitized)
        add_dependencies(sanitized_tests ${name})
    endif()
    string(REGEX REPLACE "^test_" "" room ${name})
    gtest_discover_tests(${name} TEST_PREFIX ${room}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 LABELS ${label})
endfunction()
