// In a browser, the program cannot start other programs. Its files are at the root of the page's file system, as if the
// program were there.
#include "platform/child_process.h"

namespace viewing {

std::string own_program() {
    return "/viewing-sandbox";
}

}  // namespace viewing
