// What EGL and the current context say about themselves, for `doctor` and the report of a snapshot.
#pragma once

#include <string>
#include <vector>

namespace viewing::gl {

/// Known before there is a context.
struct EglFacts {
    bool has_library = false;                    ///< libEGL.so.1 can be loaded
    std::string version;                         ///< of the client library: "1.5"
    std::vector<std::string> client_extensions;  ///< empty when no driver is installed
};
EglFacts egl_facts();

/// Of the current context.
struct ContextFacts {
    std::string version, renderer, vendor, shading_language;
    bool debug_output = false;  ///< GL tells its errors as they happen (KHR_debug)
};
ContextFacts context_facts();

}  // namespace viewing::gl
