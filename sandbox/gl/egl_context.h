// A GL context without a display: EGL by itself, no X. By default a software renderer, so that pictures repeat.
#pragma once

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

/// Owns an EGL display connection and a current OpenGL 3.3 core context without a surface. Move-only.
class EglContext {
public:
    /// `device`: "" for software (the device that says so, else surfaceless with software forced), "auto" for the first
    /// hardware device that works, else software; or a device's index. Asks for debug output. One sentence when there
    /// is none.
    static Result<EglContext> make(const std::string& device = "");

    EglContext(EglContext&& other) noexcept;
    EglContext& operator=(EglContext&& other) noexcept;
    ~EglContext();

    const std::string& description() const { return description_; }  ///< how it was made: "EGL device 0 (software)"

private:
    EglContext() = default;
    void* display_ = nullptr;
    void* context_ = nullptr;
    std::string description_;
};

}  // namespace viewing::gl
