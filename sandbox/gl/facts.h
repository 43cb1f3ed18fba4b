// Facts about EGL and the current context, for `doctor` and the report of a snapshot.
#pragma once

#include <string>
#include <vector>

namespace viewing::gl {

/// Facts about EGL that are known before there is a context.
struct EglFacts {
    bool has_library = false;                    ///< libEGL.so.1 can be loaded
    std::string version;                         ///< of the client library: "1.5"
    std::vector<std::string> client_extensions;  ///< empty when no driver is installed
};
EglFacts egl_facts();

/// Facts about the current context.
struct ContextFacts {
    std::string version, renderer, vendor, shading_language;
    bool debug_output = false;  ///< GL reports errors as they happen (KHR_debug)
};
ContextFacts context_facts();

}  // namespace viewing::gl
