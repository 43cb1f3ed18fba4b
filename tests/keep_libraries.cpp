// Linked into every program of a sanitizer build. GL drivers are unloaded when a context ends; what their libraries
// still hold then looks like leaks without a name. Libraries that stay loaded leave nothing to suppress.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) noexcept {
    return 0;
}
