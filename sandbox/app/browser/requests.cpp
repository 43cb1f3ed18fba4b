// Serves requests that page.js makes by name, for itself and for the host page: gets the state, matrices and pictures,
// sets fields, and opens states. An error is one sentence, and leaves everything unchanged.
#include <emscripten.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <string>

#include "app/browser/open_page.h"
#include "app/picture.h"
#include "gl/gl.h"
#include "image/image_size.h"
#include "image/png.h"
#include "platform/file.h"
#include "platform/text_file.h"
#include "report/matrices_report.h"
#include "state/file/link.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/words.h"
#include "topics/hidden/measured/camera_picture.h"

namespace viewing {
namespace {

/// Loads the state that a message contains as JSON, as a link, or as a preset's name. A file's name is an error.
Result<LoadedState> state_to_open(const std::string& text) {
    if (is_link(text)) return state_in_text(text, "open");
    if (text.starts_with('{')) {
        Result<LoadedState> state = state_in_text(text, "open");
        if (state) state->reach = {false, {}};  // a state in a message has no folder
        return state;
    }
    std::vector<std::string> names;
    for (const NamedFile& preset : page->presets) names.push_back(preset.name);
    if (std::find(names.begin(), names.end(), text) != names.end()) return load_state(text);
    return Error{"open: " + one_line(text) +
                 " is not a preset; use a preset's name such as \"teapot\", a state or a link" +
                 suggestion(text, names)};
}

/// The views that a request can name. A picture of the whole window has the window's size on screen.
constexpr std::array asked_views{PictureView::camera, PictureView::depth, PictureView::stencil, PictureView::window};

std::optional<PictureView> asked_view(std::string_view name) {
    const auto* const at = std::find_if(asked_views.begin(), asked_views.end(), [name](PictureView view) {
        return picture_view_names[static_cast<std::size_t>(view)] == name;
    });
    return at != asked_views.end() ? std::optional(*at) : std::nullopt;
}

/// Returns the longest picture side that this driver can draw.
int longest_side() {
    int longest = largest_image_side;
    for (const GLenum limit : {GL_MAX_TEXTURE_SIZE, GL_MAX_RENDERBUFFER_SIZE}) {
        GLint most = 0;
        glGetIntegerv(limit, &most);
        longest = std::min(longest, most);
    }
    return longest;
}

/// Returns why a picture of this size cannot be drawn; "" if it can.
std::string size_trouble(glm::dvec2 size_px) {
    const int longest = longest_side();
    const bool fits = size_px.x >= 1.0 && size_px.y >= 1.0 && size_px.x <= longest && size_px.y <= longest;
    if (fits && size_px.x * size_px.y <= double{most_drawn_pixels}) return "";
    return "picture: size must be two sides from 1 to " + std::to_string(longest) + " pixels with at most " +
           grouped_number(most_drawn_pixels) + " pixels in total, got " + shortest_number(size_px.x) + " and " +
           shortest_number(size_px.y);
}

Result<PictureRequest> picture_request(std::string_view view, glm::dvec2 size_px, double samples) {
    const std::optional<PictureView> asked = asked_view(view);
    if (!asked) {
        std::vector<std::string> names;
        for (const PictureView known : asked_views)
            names.emplace_back(picture_view_names[static_cast<std::size_t>(known)]);
        return Error{"picture: view must be one of " + joined(names) + ", got " + one_line(view)};
    }
    PictureRequest request{.view = *asked, .size_px = page->studio.shown().camera_px};
    const bool is_window = request.view == PictureView::window;
    const bool has_size = size_px != glm::dvec2(0.0), has_samples = samples != -1.0;
    if (is_window && (has_size || has_samples))
        return Error{"picture: the window is drawn as shown; omit size and samples"};
    if (const std::string trouble = has_size ? size_trouble(size_px) : ""; !trouble.empty()) return Error{trouble};
    if (has_samples && samples != 0.0 && samples != 4.0)
        return Error{"picture: samples must be 0 or 4, got " + shortest_number(samples)};
    if (has_size) request.size_px = size_px;
    if (has_samples) request.samples = static_cast<int>(samples);
    return request;
}

Result<Image> asked_picture(const PictureRequest& request, const Params& params) {
    if (request.view == PictureView::window) return page->studio.read();
    for (int most = 16; most > 0 && glGetError() != GL_NO_ERROR; --most) continue;  // discards older errors
    Result<Image> image = camera_picture(page->renderer, params, page->studio.session.scene(), request.size_px);
    if (image && glGetError() == GL_OUT_OF_MEMORY)
        return Error{"picture: the graphics driver lacks memory for " + std::to_string(request.size_px.x) + " by " +
                     std::to_string(request.size_px.y) + " pixels; request fewer"};
    return image;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The value that page_open_answer() returns on success.
constexpr const char* is_opened = "opened";

}  // namespace

std::string text_trouble(std::size_t bytes) {
    if (bytes <= max_document_bytes) return "";
    return say("This text is {count} bytes long, but the limit is {most}: nothing changed",
               "count"_a = grouped_number(static_cast<std::int64_t>(bytes)),
               "most"_a = grouped_number(static_cast<std::int64_t>(max_document_bytes)));
}

bool takes(const char* text) {
    const std::string trouble = text_trouble(std::strlen(text));
    if (trouble.empty()) return true;
    page->studio.session.report(Error{trouble});
    push(FocusChanged{true});
    return false;
}

void refuse_what_is_not_there() {
    const OutsideFile* const asked = page->studio.session.asks_to_read();
    if (!asked || is_there(asked->file)) return;
    page->studio.session.take_outcome();  // asking to read a file ended the loading; that outcome is not the final one
    page->studio.session.answer(false);
    page->studio.session.message.is_error = true;  // errors stay on screen
}

}  // namespace viewing

// Functions called by page.js. Texts are UTF-8; returned texts stay valid until the next call.
extern "C" {
using namespace viewing;

/// Returns one sentence that says why page.js must not pass on a text of this size; "" if it may.
EMSCRIPTEN_KEEPALIVE const char* page_text_trouble(double bytes) {
    return given(text_trouble(static_cast<std::size_t>(bytes)));
}

/// Shows an error that page.js has found.
EMSCRIPTEN_KEEPALIVE void page_report(const char* sentence) {
    page->studio.session.report(Error{sentence});
    push(FocusChanged{true});
}

/// Returns the whole state as JSON.
EMSCRIPTEN_KEEPALIVE const char* page_state() {
    return given(page->studio.session.text());
}

/// Returns the matrices with their properties as JSON, in the format of `viewing-sandbox matrices`.
EMSCRIPTEN_KEEPALIVE const char* page_matrices() {
    const ShownFrame& shown = page->studio.shown();
    return given(matrices_as_json(shown.derived, shown.problems).dump());
}

/// Sets fields, one per line: "light.position=[1,2,3]". Returns "" on success; on an error, sets none of them and
/// returns the error.
EMSCRIPTEN_KEEPALIVE const char* page_set(const char* text) {
    if (const std::string trouble = text_trouble(std::strlen(text)); !trouble.empty()) return given(trouble);
    Session& session = page->studio.session;
    Result<Params> changed = apply_settings(session.params, lines_of(text), "");
    if (!changed) return given(changed.error());
    session.params = *std::move(changed);
    push(FocusChanged{true});
    return given("");
}

/// Starts to open a state given as JSON, a link or a preset's name. Returns an error that is found immediately, else
/// "". page_open_answer() then reports the outcome.
EMSCRIPTEN_KEEPALIVE const char* page_open(const char* text) {
    if (const std::string trouble = text_trouble(std::strlen(text)); !trouble.empty()) return given(trouble);
    Result<LoadedState> state = state_to_open(text);
    if (!state) return given(state.error());
    // Keep the look and layout chosen by the user or the host page, unless the state sets its own.
    Session& session = page->studio.session;
    if (state->params.ui == UiParams{}) state->params.ui = session.params.ui;
    if (state->params.view.layout == LayoutParams{}) state->params.view.layout = session.params.view.layout;
    session.replace(*state);
    push(FocusChanged{true});
    return given("");
}

/// Returns the outcome of the latest page_open(): "" while it is loading, "opened", or the error.
EMSCRIPTEN_KEEPALIVE const char* page_open_answer() {
    Session& session = page->studio.session;
    session.update_scene();
    refuse_what_is_not_there();
    if (session.asks_to_read()) {
        session.take_outcome();  // asking to read a file ended the loading; that outcome is not the final one
        return given("");
    }
    if (session.loading_fraction()) return given("");
    const std::optional<Status> outcome = session.take_outcome();
    if (!outcome) return given(session.message.text.empty() ? "open: the document was not read" : session.message.text);
    return given(*outcome ? is_opened : outcome->error());
}

/// Writes a picture as a PNG file that contains its state, in the page's folder. Returns the file's path, which begins
/// with "/", or the error. If `width` and `height` are 0, the picture has the view's size; if `samples` is −1, it has
/// the state's number of samples.
EMSCRIPTEN_KEEPALIVE const char* page_picture(const char* view, double width, double height, double samples) {
    Studio& studio = page->studio;
    const Result<PictureRequest> request = picture_request(view, {width, height}, samples);
    if (!request) return given(request.error());
    const Params params = drawn_params(studio.shown().params, *request);
    const Result<Image> image = asked_picture(*request, params);
    if (!image) return given(image.error());
    const std::vector<std::uint8_t> png = encode_png(*image, write_state(studio.session.portable(params)));
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "picture.png";
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(png.data()), std::ssize(png));
    return given(file.string());
}
}
