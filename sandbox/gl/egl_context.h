// A GL context without a window system: only EGL, no X. By default, it uses a software renderer, so that pictures are
// reproducible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/result.h"

namespace viewing::gl {

/// One EGL device as `doctor` lists it.
struct DeviceInfo {
    int index = 0;
    bool software = false;
    std::string name;  ///< "software" for a software device, else the DRM node; "" if the driver reports none
};

/// Returns every EGL device; empty if EGL cannot enumerate them.
std::vector<DeviceInfo> egl_devices();

/// Speeds up a process that draws only a few pictures: the software renderer compiles its shaders without optimization
/// and for 128-bit vectors, which halves the time of a cold start and changes no pixel. Call before the first context
/// is made. Does not override GALLIVM_PERF and LP_NATIVE_VECTOR_WIDTH if the user has set them.
void prefer_quick_start();

/// If neither HOME nor a cache folder is set, turns off the driver's shader cache, since the driver would otherwise
/// look up a home folder by itself and write there. Call before the first context is made.
void keep_no_cache_without_a_home();

/// Owns an OpenGL 3.3 core context without a surface, which is current after construction. Its EGL display is shared
/// with other contexts on the same device. Move-only; destroy it in the thread where it is current.
class EglContext {
public:
    /// Makes a context. `device` is "" for software (a device that reports itself as software, otherwise surfaceless
    /// with software forced), "auto" for the first hardware device that works (software if none does), or the index of
    /// a device. Requests debug output. The error says in one sentence that no such device exists, or what failed.
    static Result<EglContext> make(const std::string& device = "");
    /// Makes a context on the first software device; returns nothing if there is none. Does not change the environment,
    /// so any thread may call it.
    static std::optional<EglContext> make_software();

    EglContext(EglContext&& other) noexcept;
    EglContext& operator=(EglContext&& other) noexcept;
    ~EglContext();

    /// Makes the context current in the calling thread; it must not be current in another. Returns false if the driver
    /// refuses.
    bool is_made_current() const;
    /// Leaves the calling thread without a context.
    void let_go() const;

    const std::string& description() const { return description_; }  ///< how it was made: "EGL device 0 (software)"

private:
    EglContext() = default;
    static std::optional<EglContext> on_display(void* display, std::string description, std::string* refused);
    static std::optional<EglContext> on_device(void* device, int index, std::string* refused);
    static std::optional<EglContext> on_first_device(bool is_software, std::string* refused);

    void* display_ = nullptr;
    void* context_ = nullptr;
    std::string description_;
};

}  // namespace viewing::gl
