// Separate from facts.cpp, because EGL's own header conflicts with the GL loader's.
#include <dlfcn.h>
#include <EGL/egl.h>

#include <sstream>

#include "gl/facts.h"

namespace viewing::gl {
namespace {

std::string egl_string(EGLint name) {
    const char* text = eglQueryString(EGL_NO_DISPLAY, name);
    return text != nullptr ? text : "";
}

}  // namespace

EglFacts egl_facts() {
    EglFacts facts;
    void* library = dlopen("libEGL.so.1", RTLD_LAZY);
    facts.has_library = library != nullptr;
    if (!facts.has_library) return facts;
    facts.version = egl_string(EGL_VERSION);
    std::istringstream words(egl_string(EGL_EXTENSIONS));
    for (std::string word; words >> word;) facts.client_extensions.push_back(word);
    dlclose(library);
    return facts;
}

}  // namespace viewing::gl
