// A GL context that needs no display, and its renderer, for every command that draws.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/picture.h"
#include "cli/options.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "render/renderer.h"

namespace viewing {

/// Throws Failure if the driver cannot start its threads here, since it would wait for them forever.
void require_threads();

/// Calls require_threads(), then makes the context that all pictures use. `device` is passed to EglContext::make.
Result<gl::EglContext> context_for_pictures(const std::string& device);

class Headless {
public:
    /// `device` is passed to EglContext::make. Throws Failure if there is no context, or if the driver rejects a
    /// shader.
    explicit Headless(const std::string& device);

    Renderer& renderer() { return *renderer_; }
    const gl::EglContext& context() const { return context_; }

    gl::DebugLog& log() { return log_; }

    /// Throws Failure with GL's message if GL has reported an error.
    void require_no_errors();

    /// Returns the value of a result that drawing produced. An error in the result, or one that GL reported, ends the
    /// command.
    template <typename T>
    T drawn(Result<T> result, ExitStatus status_of_its_error = ExitStatus::gl_error) {
        require_no_errors();
        return value_or_end(std::move(result), status_of_its_error);
    }

    /// Keeps a command's last Headless until the process exits, so that leave() skips its destructor. If leave() runs
    /// destructors, destroys the object now.
    static void keep_to_the_end(std::unique_ptr<Headless> last);

private:
    gl::EglContext context_;
    gl::DebugLog log_;
    std::optional<Renderer> renderer_;
};

/// Refuses a --size that is not possible for the view (check_picture_size).
void check_size(const Options& options, const PictureRequest& request);

/// Throws Failure if the scene is too large for a hidden-surface method, before any work on it.
void refuse_beyond_budget(const Params& params, const Derived& derived, const Scene& scene, glm::ivec2 size_px);

/// Returns the exit status for an error from draw_picture() that GL has not reported: bad_input for a view that may be
/// empty or may not fit, otherwise gl_error.
ExitStatus status_of_trouble(PictureView view);

/// Declares --device.
void add_device_option(Options& options, std::optional<std::string>& device);

/// Returns the argument for EglContext::make; refuses anything but "auto" and the index of a device.
std::string device_option(const Options& options, const std::optional<std::string>& device);

}  // namespace viewing
