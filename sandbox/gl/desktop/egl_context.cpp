#include "gl/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace viewing::gl {
namespace {

template <typename Function>
Function egl_function(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool has_word(const char* words, const char* word) {
    if (!words) return false;
    const std::size_t length = std::strlen(word);
    for (const char* at = std::strstr(words, word); at; at = std::strstr(at + 1, word))
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) return true;
    return false;
}

std::vector<EGLDeviceEXT> raw_devices() {
    const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (!query || !query(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    query(count, devices.data(), &count);
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

DeviceInfo describe(EGLDeviceEXT device, int index) {
    const auto query_string = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    DeviceInfo info{index, false, ""};
    if (!query_string) return info;
    const char* extensions = query_string(device, EGL_EXTENSIONS);
    info.software = has_word(extensions, "EGL_MESA_device_software");
    if (has_word(extensions, "EGL_EXT_device_drm"))
        if (const char* node = query_string(device, EGL_DRM_DEVICE_FILE_EXT)) info.name = node;
    if (info.software) info.name = "software";
    return info;
}

EGLDisplay platform_display(EGLenum platform, void* native) {
    const auto get = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (!get || !has_word(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_platform_base"))
        return EGL_NO_DISPLAY;
    return get(platform, native, nullptr);
}

/// Counts contexts per display. A device has only one display per process, however often it is requested, and only the
/// last context on the display may terminate it.
struct DisplayUse {
    std::mutex mutex;
    std::map<EGLDisplay, int> contexts;
};
DisplayUse display_use;

EGLContext core_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    // No surface is ever made: all drawing goes into our own framebuffers, which have their own formats.
    const EGLint config_wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, config_wish, &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
    const EGLint context_wish[] = {
        EGL_CONTEXT_MAJOR_VERSION,
        3,
        EGL_CONTEXT_MINOR_VERSION,
        3,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_CONTEXT_FLAGS_KHR,  // from the extension, since EGL 1.4 itself has no such attribute
        EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
        EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wish);
}

/// Returns the error of the last EGL call, such as "EGL_BAD_MATCH".
std::string egl_error() {
    constexpr const char* names[] = {"no error",          "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
                                     "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
                                     "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
                                     "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
                                     "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
    const EGLint code = eglGetError() - EGL_SUCCESS;
    return code >= 0 && code < static_cast<EGLint>(std::size(names)) ? names[code] : "an unknown error";
}

/// Appends what failed on a display, and the EGL error, to `refused`, unless `refused` is null.
void note(std::string* refused, const std::string& description, const char* what) {
    const std::string why = egl_error();
    if (refused == nullptr) return;
    *refused += (refused->empty() ? "" : "; ") + description + " " + what + " (" + why + ")";
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

}  // namespace

std::vector<DeviceInfo> egl_devices() {
    std::vector<DeviceInfo> infos;
    for (EGLDeviceEXT device : raw_devices()) infos.push_back(describe(device, static_cast<int>(infos.size())));
    return infos;
}

void prefer_quick_start() {
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
}

void keep_no_cache_without_a_home() {
    constexpr const char* places[] = {"HOME", "XDG_CACHE_HOME", "MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR"};
    if (std::none_of(std::begin(places), std::end(places), is_set)) setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

std::optional<EglContext> EglContext::on_display(void* display, std::string description, std::string* refused) {
    if (display == EGL_NO_DISPLAY) return std::nullopt;
    EglContext made;
    {
        const std::lock_guard lock(display_use.mutex);
        if (!eglInitialize(display, nullptr, nullptr)) {
            note(refused, description, "cannot be initialized");
            return std::nullopt;
        }
        ++display_use.contexts[display];
    }
    made.display_ = display;
    made.description_ = std::move(description);
    made.context_ = core_context(display);
    if (made.context_ == EGL_NO_CONTEXT || !made.is_made_current()) {
        note(refused, made.description_, "provides no OpenGL 3.3 core context");
        return std::nullopt;
    }
    return made;
}

std::optional<EglContext> EglContext::on_device(void* device, int index, std::string* refused) {
    const bool is_software = describe(device, index).software;
    return on_display(platform_display(EGL_PLATFORM_DEVICE_EXT, device),
                      "EGL device " + std::to_string(index) + (is_software ? " (software)" : ""), refused);
}

std::optional<EglContext> EglContext::on_first_device(bool is_software, std::string* refused) {
    int index = 0;
    for (EGLDeviceEXT device : raw_devices()) {
        if (describe(device, index).software == is_software)
            if (std::optional<EglContext> made = on_device(device, index, refused)) return made;
        ++index;
    }
    return std::nullopt;
}

std::optional<EglContext> EglContext::make_software() {
    return on_first_device(true, nullptr);
}

bool EglContext::is_made_current() const {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, static_cast<EGLContext>(context_)) == EGL_TRUE;
}

void EglContext::let_go() const {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

Result<EglContext> EglContext::make(const std::string& wish) {
    const std::vector<EGLDeviceEXT> devices = raw_devices();
    const auto count = static_cast<int>(devices.size());
    std::string refused;

    if (!wish.empty() && wish != "auto") {
        char* end = nullptr;
        const long index = std::strtol(wish.c_str(), &end, 10);
        if (*end != '\0' || index < 0 || index >= count)
            return Error{"--device " + wish + ": there is no such EGL device; use auto or 0 … " +
                         std::to_string(count - 1) + " (see viewing-sandbox doctor)"};
        const auto at = static_cast<int>(index);
        if (auto made = on_device(devices[at], at, &refused)) return std::move(*made);
        return Error{"--device " + wish + ": " + refused};
    }
    if (wish == "auto")
        if (std::optional<EglContext> made = on_first_device(false, &refused)) return std::move(*made);
    if (std::optional<EglContext> made = on_first_device(true, &refused)) return std::move(*made);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    if (auto made = on_display(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY),
                               "EGL surfaceless (software forced)", &refused))
        return std::move(*made);
    if (!refused.empty())
        return Error{"no OpenGL 3.3 core context: there is a driver, but " + refused + "; see viewing-sandbox doctor"};
    return Error{
        "no OpenGL 3.3 core context: EGL offers neither a software device nor a surfaceless display; install libegl1 "
        "and libgl1-mesa-dri, and see viewing-sandbox doctor"};
}

EglContext::EglContext(EglContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      description_(std::move(other.description_)) {}

EglContext& EglContext::operator=(EglContext&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    std::swap(description_, other.description_);
    return *this;
}

EglContext::~EglContext() {
    if (!display_) return;
    let_go();
    if (context_) eglDestroyContext(display_, static_cast<EGLContext>(context_));
    const std::lock_guard lock(display_use.mutex);
    if (--display_use.contexts[display_] == 0) eglTerminate(display_);
}

}  // namespace viewing::gl
