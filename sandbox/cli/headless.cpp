#include "cli/headless.h"

#include "cli/option_values.h"
#include "platform/heap.h"
#include "platform/leave.h"
#include "platform/threads.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {

void require_threads() {
    if (!can_start_threads(threads_of_a_driver()))
        throw Failure(ExitStatus::internal_error,
                      "cannot start the threads that the graphics driver needs, or allocate their memory; check ulimit "
                      "-u, ulimit -v and the container's limits");
}

Result<gl::EglContext> context_for_pictures(const std::string& device) {
    require_threads();
    gl::prefer_quick_start();
    take_large_pages();
    return gl::EglContext::make(device);
}

Headless::Headless(const std::string& device)
    : context_(value_or_end(context_for_pictures(device), ExitStatus::no_context)) {
    Result<Renderer> made = Renderer::make();
    if (!made) throw Failure(ExitStatus::gl_error, made.error());
    renderer_.emplace(*std::move(made));
    require_no_errors();
}

void Headless::keep_to_the_end(std::unique_ptr<Headless> last) {
    static std::unique_ptr<Headless> kept;
    if (leaves_at_once) kept = std::move(last);
}

void Headless::require_no_errors() {
    const std::vector<std::string>& errors = log_.errors();
    if (errors.empty()) return;
    const std::string more = errors.size() > 1 ? " (and " + std::to_string(errors.size() - 1) + " more)" : "";
    throw Failure(ExitStatus::gl_error, "GL error: " + errors.front() + more);
}

void check_size(const Options& options, const PictureRequest& request) {
    if (const Status fits = check_picture_size(request.view, request.size_px); !fits)
        options.refuse("--size: " + fits.error());
}

void refuse_beyond_budget(const Params& params, const Derived& derived, const Scene& scene, glm::ivec2 size_px) {
    if (const auto question = hidden_question(params, derived, size_px)) end_if(beyond_hidden_budget(scene, *question));
}

ExitStatus status_of_trouble(PictureView view) {
    return view > PictureView::observer ? ExitStatus::bad_input : ExitStatus::gl_error;
}

void add_device_option(Options& options, std::optional<std::string>& device) {
    options.text("--device", "N|auto", device,
                 "EGL device to draw with: its number (viewing-sandbox doctor), or auto for the first hardware device "
                 "that works; default: software, whose pictures are reproducible");
}

std::string device_option(const Options& options, const std::optional<std::string>& device) {
    if (!device || *device == "auto") return device.value_or("");
    const auto count = static_cast<int>(gl::egl_devices().size());
    if (count == 0) throw Failure(ExitStatus::no_context, "--device " + *device + ": EGL lists no devices here");
    whole_option(options, "--device", *device, 0, count - 1);
    return *device;
}

}  // namespace viewing
