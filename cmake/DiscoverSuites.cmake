# Read by CTest before it runs: registers one case ROOM.Suite a GoogleTest suite of `program`, and splits long suites into
# shards ROOM.Suite.1of3. A process a suite, not one a case: the OpenCL driver takes a third of a second to start, most
# cases take less, and kernels made for one case serve the next.
# Set before: program, room, labels, first (TRUE: long ones, started before others), results (folder of the JUnit files),
# environment. Each suite's own result is RESULTS/NAME.xml with _ for /.
set(cases_a_shard 60)
if(NOT EXISTS "${program}")
    add_test("${room}.NOT_BUILT" "${program}")
    return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE status
                TIMEOUT 60 ERROR_VARIABLE complaint)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} does not list its tests (${status}): ${complaint}")
endif()
string(REPLACE ";" "," listing "${listing}")
string(REGEX REPLACE "#[^\n]*" "" listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")

set(suites "")
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)\\. *$")
        set(suite "${CMAKE_MATCH_1}")
        list(APPEND suites "${suite}")
        set("cases_${suite}" 0)
    elseif(line MATCHES "^  [^ ]")
        math(EXPR "cases_${suite}" "${cases_${suite}} + 1")
    endif()
endforeach()

foreach(suite IN LISTS suites)
    math(EXPR shards "(${cases_${suite}} + ${cases_a_shard} - 1) / ${cases_a_shard}")
    foreach(shard RANGE 1 ${shards})
        set(name "${room}.${suite}")
        if(shards GREATER 1)
            string(APPEND name ".${shard}of${shards}")
        endif()
        math(EXPR index "${shard} - 1")
        string(REPLACE "/" "_" file "${name}")
        add_test("${name}" "${program}" "--gtest_filter=${suite}.*")
        set(variables "GTEST_BRIEF=1" "GTEST_OUTPUT=xml:${results}/${file}.xml" "GTEST_TOTAL_SHARDS=${shards}"
                      "GTEST_SHARD_INDEX=${index}" ${environment})
        set_tests_properties("${name}" PROPERTIES TIMEOUT 1200 LABELS "${labels}" ENVIRONMENT "${variables}")
        if(first)
            set_tests_properties("${name}" PROPERTIES COST 1000)
        endif()
    endforeach()
endforeach()
