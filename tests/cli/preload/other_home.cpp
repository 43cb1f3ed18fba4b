// This library is loaded into the program before its other libraries, so that getpwuid_r() returns $OTHER_HOME as every
// user's home.
#include <dlfcn.h>
#include <pwd.h>

#include <cstdlib>

extern "C" int getpwuid_r(uid_t user, passwd* entry, char* buffer, size_t size, passwd** result) {
    using Function = int (*)(uid_t, passwd*, char*, size_t, passwd**);
    static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "getpwuid_r"));
    const int failure = next(user, entry, buffer, size, result);
    if (failure == 0 && *result != nullptr) entry->pw_dir = std::getenv("OTHER_HOME");
    return failure;
}
