// A browser has one program, whose files lie beside it at the root.
#include "platform/child_process.h"

namespace viewing {

std::string own_program() {
    return "/viewing-sandbox";
}

}  // namespace viewing
