// Linked into every program of a sanitizer build. GL drivers are unloaded when a context ends, and the memory that
// their libraries still hold then looks like leaks from unknown code. Keeping the libraries loaded avoids suppressions.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) noexcept {
    return 0;
}
