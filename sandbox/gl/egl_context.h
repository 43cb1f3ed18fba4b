// A GL context without a display: EGL by itself, no X. By default a software renderer, so that pictures repeat.
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
    std::string name;  ///< the DRM node or the renderer's extension, "" when the driver says nothing
};

/// Every device EGL knows; empty when it cannot enumerate them.
std::vector<DeviceInfo> egl_devices();

/// For a process that draws few pictures: the software renderer compiles its shaders without optimising them and for
/// vectors of 128 bits, which halves a cold start and changes no pixel. Call before the first context; a person's own
/// GALLIVM_PERF and LP_NATIVE_VECTOR_WIDTH stay.
void prefer_quick_start();

/// Where neither HOME nor a folder for caches is set, the driver keeps no compiled shaders: it would look up a home by
/// itself and write there. Call before the first context.
void keep_no_cache_without_a_home();

/// Owns an OpenGL 3.3 core context without a surface, current when it is made, on an EGL display that it shares with
/// others on the same device. Move-only; ends in the thread that has it.
class EglContext {
public:
    /// `device`: "" for software (the device that says so, else surfaceless with software forced), "auto" for the first
    /// hardware device that works, else software; or a device's index. Asks for debug output. One sentence when there
    /// is none: what there is, and what each of it refused.
    static Result<EglContext> make(const std::string& device = "");
    /// On the first software device; none where there is none. Leaves the environment alone: any thread may ask.
    static std::optional<EglContext> make_software();

    EglContext(EglContext&& other) noexcept;
    EglContext& operator=(EglContext&& other) noexcept;
    ~EglContext();

    /// From now on the calling thread's; no other may have it then. False: the driver refuses.
    bool is_made_current() const;
    /// The calling thread has none any more.
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
