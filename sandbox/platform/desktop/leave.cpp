#include "platform/leave.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace viewing {

void leave(int status) {
    if constexpr (!leaves_at_once) std::exit(status);
    std::fflush(nullptr);
    ::_exit(status);
}

}  // namespace viewing
