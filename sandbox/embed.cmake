# Embeds files in the program, so that it needs neither the source tree nor installed fonts at run time. The assembler's
# .incbin copies the files unchanged, so the build generates no source of millions of numbers, and a changed file costs
# one assembler run. Without an assembler for ELF or WebAssembly, the files become C++ arrays.
set(default_embed array)
if(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF" OR EMSCRIPTEN)
    set(default_embed incbin)
endif()
set(VIEWING_EMBED ${default_embed} CACHE STRING "How files are put into the program: incbin or array")
set_property(CACHE VIEWING_EMBED PROPERTY STRINGS incbin array)

# embed_files(TARGET HEADER ACCESSOR [TEXT] [WAY incbin|array] FILES…)
# Makes the static library TARGET. Its header, included as HEADER, declares
#     std::string_view           viewing::ACCESSOR(std::string_view file_name);   with TEXT
#     std::span<const std::byte> viewing::ACCESSOR(std::string_view file_name);   without
# which return the bytes of a file by its name without folders, or nothing for an unknown name.
function(embed_files target header accessor)
    cmake_parse_arguments(EMBED "TEXT" "WAY" "" ${ARGN})
    set(files ${EMBED_UNPARSED_ARGUMENTS})
    if(NOT EMBED_WAY)
        set(EMBED_WAY ${VIEWING_EMBED})
    endif()
    if(NOT EMBED_WAY MATCHES "^(incbin|array)$")
        message(FATAL_ERROR "VIEWING_EMBED is \"${EMBED_WAY}\"; it can be incbin or array")
    endif()
    if(EMBED_TEXT)
        set(view "std::string_view")
        set(element "char")
        set(view_header "<string_view>")
    else()
        set(view "std::span<const std::byte>")
        set(element "std::byte")
        set(view_header "<cstddef>\n#include <span>\n#include <string_view>")
    endif()

    set(assembly "")
    set(symbols "")
    set(branches "")
    set(index 0)
    foreach(file IN LISTS files)
        cmake_path(GET file FILENAME name)
        set(symbol "${accessor}_${index}")
        if(EMBED_WAY STREQUAL "incbin")
            if(EMSCRIPTEN)  # each object needs its own section and size
                string(APPEND assembly
                    "    .section .rodata.${symbol},\"\",@\n    .global ${symbol}\n    .p2align 4\n${symbol}:\n    .incbin \"${file}\"\n"
                    ".L${symbol}_end:\n    .byte 0\n.L${symbol}_after:\n    .size ${symbol}, .L${symbol}_after - ${symbol}\n"
                    "    .section .rodata.${symbol}_size,\"\",@\n    .global ${symbol}_size\n    .p2align 3\n${symbol}_size:\n"
                    "    .int64 .L${symbol}_end - ${symbol}\n    .size ${symbol}_size, 8\n")
            else()
                string(APPEND assembly
                    "    .section .rodata\n    .balign 16\n    .global ${symbol}\n${symbol}:\n    .incbin \"${file}\"\n${symbol}_end:\n"
                    "    .byte 0\n    .balign 8\n    .global ${symbol}_size\n${symbol}_size:\n    .8byte ${symbol}_end - ${symbol}\n")
            endif()
            string(APPEND symbols
                "extern const unsigned char ${symbol}[];\nextern const std::uint64_t ${symbol}_size;\n")
        else()
            file(READ ${file} bytes HEX)
            string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
            string(REPEAT "." 80 line)
            string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
            string(APPEND symbols
                "const unsigned char ${symbol}[] = {\n${bytes}0};\nconst std::uint64_t ${symbol}_size = sizeof ${symbol} - 1;\n")
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        endif()
        string(APPEND branches
            "    if (file_name == \"${name}\")\n        return {reinterpret_cast<const ${element}*>(${symbol}), static_cast<std::size_t>(${symbol}_size)};\n")
        math(EXPR index "${index} + 1")
    endforeach()
    if(NOT EMSCRIPTEN)
        string(APPEND assembly "    .section .note.GNU-stack,\"\",%progbits\n")
    endif()

    set(folder ${PROJECT_BINARY_DIR}/generated)
    file(CONFIGURE OUTPUT ${folder}/${header} @ONLY CONTENT
"// Made by sandbox/embed.cmake. The files that are part of the program, by name.
#pragma once

#include @view_header@

namespace viewing {

/// The bytes of an embedded file; empty when there is none of this name.
@view@ @accessor@(std::string_view file_name);

}  // namespace viewing
")
    file(CONFIGURE OUTPUT ${folder}/${target}.cpp @ONLY CONTENT
"#include \"@header@\"

#include <cstddef>
#include <cstdint>

@symbols@
namespace viewing {

@view@ @accessor@([[maybe_unused]] std::string_view file_name) {
@branches@    return {};
}

}  // namespace viewing
")
    add_library(${target} STATIC ${folder}/${target}.cpp)
    if(EMBED_WAY STREQUAL "incbin")
        file(CONFIGURE OUTPUT ${folder}/${target}.S CONTENT "@assembly@" @ONLY)
        set_source_files_properties(${folder}/${target}.S PROPERTIES OBJECT_DEPENDS "${files}")
        target_sources(${target} PRIVATE ${folder}/${target}.S)
    endif()
    target_include_directories(${target} PUBLIC ${folder})
endfunction()

# find_font(RESULT FILE PACKAGE): the path of a font in any of the system's font folders; without one, an error that
# names Debian's PACKAGE.
function(find_font result file package)
    file(GLOB_RECURSE fonts /usr/share/fonts/${file} /usr/local/share/fonts/${file})
    list(APPEND fonts NOTFOUND)
    list(GET fonts 0 font)
    set(VIEWING_FONT_${file} "${font}" CACHE FILEPATH "The font ${file}")
    mark_as_advanced(VIEWING_FONT_${file})
    if(NOT VIEWING_FONT_${file})
        unset(VIEWING_FONT_${file} CACHE)  # look again on the next run
        message(FATAL_ERROR "The font ${file} is missing: install it (Debian's package ${package}), "
                            "or pass -DVIEWING_FONT_${file}=/path/to/${file}")
    endif()
    set(${result} ${VIEWING_FONT_${file}} PARENT_SCOPE)
endfunction()

function(embed_shaders)
    file(GLOB shaders CONFIGURE_DEPENDS
         ${PROJECT_SOURCE_DIR}/shaders/*.vert ${PROJECT_SOURCE_DIR}/shaders/*.frag ${PROJECT_SOURCE_DIR}/shaders/*.glsl)
    embed_files(embedded_shaders embedded/shaders.h embedded_shader TEXT ${shaders})
endfunction()

function(embed_manual)
    file(GLOB topics CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/assets/manual/*.md)
    embed_files(embedded_manual embedded/manual.h embedded_manual TEXT ${topics})
endfunction()

function(embed_fonts)
    find_font(regular Inter-Regular.otf fonts-inter)
    find_font(semibold Inter-SemiBold.otf fonts-inter)
    find_font(mono JetBrainsMono-Regular.ttf fonts-jetbrains-mono)
    find_font(signs DejaVuSans.ttf fonts-dejavu-core)
    find_font(korean NanumBarunGothic.ttf fonts-nanum)
    find_font(korean_bold NanumBarunGothicBold.ttf fonts-nanum)
    set(fonts ${regular} ${semibold} ${mono} ${signs} ${korean} ${korean_bold})
    if(EMSCRIPTEN)
        smaller_fonts(fonts ${fonts})
    endif()
    embed_files(embedded_fonts embedded/fonts.h embedded_font ${fonts})
endfunction()

function(embed_pages)
    set(page ${PROJECT_SOURCE_DIR}/sandbox/suite/page)
    embed_files(embedded_pages embedded/pages.h embedded_page TEXT ${page}/report.html ${page}/report.css ${page}/report.js)
endfunction()
