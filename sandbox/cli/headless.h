// A context without a display and a renderer in it: what every command that draws starts with.
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

/// Throws Failure where the driver could not start its threads: it would wait for them for ever.
void require_threads();

/// What every picture is drawn in, made after require_threads(). `device` as EglContext::make takes it.
Result<gl::EglContext> context_for_pictures(const std::string& device);

class Headless {
public:
    /// `device` as EglContext::make takes it. Throws Failure: no context, or a driver that refuses a shader.
    explicit Headless(const std::string& device);

    Renderer& renderer() { return *renderer_; }
    const gl::EglContext& context() const { return context_; }

    gl::DebugLog& log() { return log_; }

    /// Throws Failure with GL's own words when it has reported an error so far.
    void require_no_errors();

    /// The value of a drawing; its error, or one that GL reported, ends the command.
    template <typename T>
    T drawn(Result<T> result, ExitStatus status_of_its_error = ExitStatus::gl_error) {
        require_no_errors();
        return value_or_end(std::move(result), status_of_its_error);
    }

    /// Where leave() takes down nothing, this is not taken down either. For the last one of a command.
    static void keep_to_the_end(std::unique_ptr<Headless> last);

private:
    gl::EglContext context_;
    gl::DebugLog log_;
    std::optional<Renderer> renderer_;
};

/// Refuses a --size that the view cannot have (check_picture_size).
void check_size(const Options& options, const PictureRequest& request);

/// Throws Failure where a hidden-surface method does not take the scene on: before anything is spent on it.
void refuse_beyond_budget(const Params& params, const Derived& derived, const Scene& scene, glm::ivec2 size_px);

/// What an error of draw_picture is without one of GL: a view by itself that has nothing to show, or no room for it.
ExitStatus status_of_trouble(PictureView view);

/// Declares --device.
void add_device_option(Options& options, std::optional<std::string>& device);

/// The wish for EglContext::make; refuses what is neither "auto" nor the index of a device.
std::string device_option(const Options& options, const std::optional<std::string>& device);

}  // namespace viewing
