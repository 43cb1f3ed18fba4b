# The libraries of the browser's build, under the names that CMakeLists.txt links. Header-only libraries use Debian's
# installed headers; the others are built from Debian's source packages, which sandbox/web fetches.
set(VIEWING_WEB_SOURCES ${PROJECT_SOURCE_DIR}/build/web-sources CACHE PATH "Debian's source packages, unpacked")

# source_folder(RESULT NAME): the folder of a source package, whatever its version.
function(source_folder result name)
    file(GLOB folders LIST_DIRECTORIES TRUE ${VIEWING_WEB_SOURCES}/${name}-*/)
    list(FILTER folders EXCLUDE REGEX "\\.(dsc|xz|gz|bz2)$")
    list(LENGTH folders count)
    if(NOT count EQUAL 1)
        message(FATAL_ERROR "Debian's source package ${name} has to be unpacked once in ${VIEWING_WEB_SOURCES}: run sandbox/web")
    endif()
    set(${result} ${folders} PARENT_SCOPE)
endfunction()

# Use WebAssembly exceptions in every file, C included: they must be able to pass through each call.
add_compile_options(-fwasm-exceptions)

# Include only links to these libraries' headers: /usr/include itself has the headers of another C library.
set(web_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${web_headers})
foreach(name glm nlohmann fmt stb)
    if(NOT EXISTS /usr/include/${name})
        message(FATAL_ERROR "/usr/include/${name} is missing: run sandbox/web, which installs it")
    endif()
    file(CREATE_LINK /usr/include/${name} ${web_headers}/${name} SYMBOLIC)
endforeach()
# These headers come first: they add what this compiler's C++ library and GL headers lack. Each includes the original.
include_directories(BEFORE SYSTEM ${PROJECT_SOURCE_DIR}/sandbox/platform/browser/headers)
include_directories(SYSTEM ${web_headers})

# headers_alone(NAME [DEFINITION…])
function(headers_alone name)
    add_library(${name} INTERFACE IMPORTED GLOBAL)
    target_compile_definitions(${name} INTERFACE ${ARGN})
endfunction()
headers_alone(glm::glm)
headers_alone(nlohmann_json::nlohmann_json)
headers_alone(fmt::fmt FMT_HEADER_ONLY=1)
headers_alone(Threads::Threads)
headers_alone(PkgConfig::epoxy)
# Used only by code in a room's folder `desktop`, which this build leaves out.
foreach(name PkgConfig::egl PkgConfig::cairo PkgConfig::harfbuzz_subset PkgConfig::qrencode glfw)
    headers_alone(${name})
endforeach()

# from_source(NAME FOLDER SOURCES…): a library of third-party files, without our warnings.
function(from_source name folder)
    list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE sources)
    string(MAKE_C_IDENTIFIER web_${name} target)
    add_library(${target} STATIC ${sources})
    target_include_directories(${target} SYSTEM PUBLIC ${folder})
    target_compile_options(${target} PRIVATE -w)
    add_library(${name} ALIAS ${target})
endfunction()

source_folder(imgui imgui)
from_source(PkgConfig::imgui ${imgui} imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp
            backends/imgui_impl_opengl3.cpp misc/cpp/imgui_stdlib.cpp)
# A draw list may have more than 65,536 vertices, and OpenGL ES 3.0 has no base vertex.
target_compile_definitions(web_PkgConfig__imgui PUBLIC "ImDrawIdx=unsigned int" IMGUI_IMPL_OPENGL_ES3
                           IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_METRICS_WINDOW)
target_include_directories(web_PkgConfig__imgui SYSTEM PUBLIC ${imgui}/misc/cpp)

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/stb.cpp @ONLY CONTENT
     "#define STB_TRUETYPE_IMPLEMENTATION\n#include <stb/stb_truetype.h>\n")
from_source(PkgConfig::stb ${PROJECT_BINARY_DIR}/generated stb.cpp)

source_folder(lua lua5.4)
from_source(PkgConfig::lua ${lua}/src lapi.c lauxlib.c lbaselib.c lcode.c lcorolib.c lctype.c ldblib.c ldebug.c ldo.c ldump.c
            lfunc.c lgc.c linit.c liolib.c llex.c lmathlib.c lmem.c loadlib.c lobject.c lopcodes.c loslib.c lparser.c lstate.c
            lstring.c lstrlib.c ltable.c ltablib.c ltm.c lundump.c lutf8lib.c lvm.c lzio.c)
# Lua's headers, as patched by Debian, include this file for the architecture's module path. The page has no modules.
file(CONFIGURE OUTPUT ${web_headers}/lua5.4-deb-multiarch.h CONTENT "#define DEB_HOST_MULTIARCH \"\"\n")
get_target_property(lua_sources web_PkgConfig__lua SOURCES)
set_source_files_properties(${lua_sources} PROPERTIES LANGUAGE CXX)  # so that Lua's errors unwind, as in lua5.4-c++

source_folder(zlib zlib)
from_source(ZLIB::ZLIB ${zlib} adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c uncompr.c zutil.c)

source_folder(png libpng1.6)
configure_file(${png}/scripts/pnglibconf.h.prebuilt ${web_headers}/pnglibconf.h COPYONLY)
from_source(PNG::PNG ${png} png.c pngerror.c pngget.c pngmem.c pngpread.c pngread.c pngrio.c pngrtran.c pngrutil.c pngset.c
            pngtrans.c pngwio.c pngwrite.c pngwtran.c pngwutil.c)
target_link_libraries(web_PNG__PNG PUBLIC ZLIB::ZLIB)

# smaller_fonts(RESULT FONTS…): reduces fonts with HarfBuzz to what the window can show (ui/window/fonts.cpp). The
# Korean ones stay beside the page, which fetches them when Korean is chosen.
# They keep the 2,350 syllables of KS X 1001, and the letters and signs that Korean text and names need.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/korean.py CONTENT [[
import sys
rows = [bytes((row, cell)).decode("euc-kr") for row in range(0xB0, 0xC9) for cell in range(0xA1, 0xFF)]
signs = [chr(code) for first, last in ((0x3000, 0x303F), (0x3131, 0x318E), (0xFF01, 0xFF5E)) for code in range(first, last + 1)]
open(sys.argv[1], "w", encoding="utf-8").write("".join(rows + signs))
]])
execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_BINARY_DIR}/generated/korean.py ${PROJECT_BINARY_DIR}/generated/korean.txt
                COMMAND_ERROR_IS_FATAL ANY)
find_program(HB_SUBSET hb-subset NO_CMAKE_FIND_ROOT_PATH REQUIRED)
function(smaller_fonts result)
    set(folder ${PROJECT_BINARY_DIR}/fonts)
    file(MAKE_DIRECTORY ${folder})
    set(embedded "")
    set(beside "")
    foreach(font IN LISTS ARGN)
        cmake_path(GET font FILENAME name)
        set(characters --unicodes=20-FF,2010-2026,2032,2033,2070-209C,20AC,2190-2193,2212,2260-2265)
        if(name MATCHES "^DejaVu")
            set(characters --unicodes=391-3C9,1D40-1D47,2113,2070-209C,2190-21FF,2200-22FF,2308-230B,2318,25A0-25FF,2600-2604,2713-2717,26A0,27F5-27F7)
        elseif(name MATCHES "^Nanum")
            set(characters --text-file=${PROJECT_BINARY_DIR}/generated/korean.txt)
        endif()
        add_custom_command(OUTPUT ${folder}/${name} DEPENDS ${font} VERBATIM
                           COMMAND ${HB_SUBSET} ${font} --output-file=${folder}/${name} ${characters} --no-hinting --layout-features=)
        if(name MATCHES "^Nanum")
            list(APPEND beside ${folder}/${name})
        else()
            list(APPEND embedded ${folder}/${name})
        endif()
    endforeach()
    set(${result} ${embedded} PARENT_SCOPE)
    set(korean_fonts ${beside} CACHE INTERNAL "")
endfunction()

# Builds the program as a page in build/web: index.html, its scripts and the module, with the Korean fonts beside them.
function(add_page)
    set(page ${PROJECT_SOURCE_DIR}/sandbox/app/browser/page)
    set(page_scripts net.js kept.js page.js messages.js)
    set(folder ${PROJECT_SOURCE_DIR}/build/web)
    file(GLOB_RECURSE assets_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/assets/*.json ${PROJECT_SOURCE_DIR}/assets/*.po)
    add_executable(web ${PROJECT_SOURCE_DIR}/sandbox/page_main.cpp)
    target_link_libraries(web PRIVATE app)
    set_target_properties(web PROPERTIES OUTPUT_NAME viewing-sandbox RUNTIME_OUTPUT_DIRECTORY ${folder}
                          LINK_DEPENDS "${assets_files}"
                          # Lets any Node, not only Debian's, find emscripten's packages where Debian installs them.
                          RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
    set(assets)
    foreach(name scenes presets lessons lectures exercises text lecture.json)
        list(APPEND assets "SHELL:--embed-file ${PROJECT_SOURCE_DIR}/assets/${name}@/assets/${name}")
    endforeach()
    target_link_options(web PRIVATE ${assets} -fwasm-exceptions -O2
                        -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH=1 -sFORCE_FILESYSTEM=1 -sENVIRONMENT=web
                        -sEXPORTED_FUNCTIONS=_main,_malloc,_free)
    list(TRANSFORM page_scripts PREPEND ${page}/)
    set(beside ${page}/index.html ${page}/page.css ${page_scripts} ${korean_fonts})
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/beside DEPENDS ${beside}
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
                       COMMAND ${CMAKE_COMMAND} -E copy_if_different ${beside} ${folder}
                       COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/beside)
    add_custom_target(page_files DEPENDS ${PROJECT_BINARY_DIR}/beside)
    add_dependencies(web page_files)
endfunction()
