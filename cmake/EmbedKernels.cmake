# Embeds text files as byte arrays, and checks kernel variants with Clang. Run with -P, this file is its own generator:
#   cmake -DROOT=DIR -DFILES=a,b,... -DOUTPUT=x.cpp -P EmbedKernels.cmake
set(LACUNA_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    set(arrays "")
    set(rows "")
    set(number 0)
    string(REPLACE "," ";" FILES "${FILES}")
    foreach(name IN LISTS FILES)
        file(READ ${ROOT}/${name} bytes HEX)
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
        # A null byte behind the text: no array is empty.
        string(APPEND arrays "const unsigned char k_file_${number}[] = {${bytes}0x00};\n")
        string(APPEND rows "    {\"${name}\", k_file_${number}, sizeof k_file_${number} - 1},\n")
        math(EXPR number "${number} + 1")
    endforeach()
    file(WRITE ${OUTPUT} "// Written by cmake/EmbedKernels.cmake from the files of kernels/.\n"
         "#include \"core/compute/embedded_kernels.h\"\n\nnamespace lacuna {\nnamespace {\n${arrays}"
         "const EmbeddedKernelFile k_files[] = {\n${rows}    {nullptr, nullptr, 0}};\n}  // namespace\n\n"
         "std::span<const EmbeddedKernelFile> embedded_kernel_files() { return {k_files, ${number}}; }\n"
         "}  // namespace lacuna\n")
    return()
endif()

# lacuna_embed_kernels(TARGET ROOT files...): static library TARGET holding the files, named relative to ROOT.
function(lacuna_embed_kernels target root)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_kernels.cpp)
    list(JOIN ARGN "," names)
    set(paths ${ARGN})
    list(TRANSFORM paths PREPEND ${root}/)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DROOT=${root} -DFILES=${names} -DOUTPUT=${output} -P ${LACUNA_EMBED_SCRIPT}
        DEPENDS ${paths} ${LACUNA_EMBED_SCRIPT}
        COMMENT "Embedding the kernel sources" VERBATIM)
    add_library(${target} STATIC ${output})
endfunction()

# lacuna_check_kernels(TARGET ROOT LIST): part of ALL; one Clang syntax check a line of LIST ("file.cl -Doption ..."),
# repeated only when the line or a file it includes has changed. Nothing is checked where there is no Clang.
function(lacuna_check_kernels target root list)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/${list})
    find_program(LACUNA_CLANG NAMES clang clang-14 clang-15 clang-16 DOC "Clang, to check kernels at build time")
    if(NOT LACUNA_CLANG)
        message(STATUS "No clang found: kernels are not checked at build time")
        add_custom_target(${target} ALL)
        return()
    endif()
    set(stamps "")
    file(STRINGS ${root}/${list} lines REGEX "^[^#]")
    list(REMOVE_DUPLICATES lines)
    foreach(line IN LISTS lines)
        separate_arguments(words UNIX_COMMAND "${line}")
        list(POP_FRONT words source)
        string(MD5 tag "${line}")
        string(SUBSTRING ${tag} 0 12 tag)
        string(REPLACE "/" "-" stem ${source})
        set(stamp ${CMAKE_CURRENT_BINARY_DIR}/check/${stem}-${tag}.stamp)
        add_custom_command(OUTPUT ${stamp}
            COMMAND ${LACUNA_CLANG} -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -target spir64 -fsyntax-only
                    -Wall -Wdouble-promotion -Wno-unused-function -Wno-unused-variable -Wno-unused-const-variable
                    -I ${root} ${words}
                    -MD -MF ${stamp}.d -MT ${stamp} ${root}/${source}
            COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
            DEPENDS ${root}/${source} DEPFILE ${stamp}.d
            COMMENT "Checking kernel ${line}" VERBATIM)
        list(APPEND stamps ${stamp})
    endforeach()
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/check)
    add_custom_target(${target} ALL DEPENDS ${stamps})
endfunction()
