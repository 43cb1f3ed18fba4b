#include "app/resting_window.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "figure/faces.h"
#include "state/fields.h"
#include "ui/parts/topics.h"
#include "ui/views/lower_view.h"
#include "ui/window/recording.h"

namespace viewing {
namespace {

/// Text is unreadable below half its usual size, and too large for a figure above twice its usual size.
constexpr double least_size = 0.5, most_size = 2.0;
/// The fraction of the height that counts as full. A view that fills more is not enlarged.
constexpr double full_share = 0.9;

ViewName maximized(PictureView view) {
    if (view == PictureView::window) return ViewName::none;
    if (view == PictureView::matrices) return ViewName::matrices;
    return view == PictureView::camera ? ViewName::camera : ViewName::lower_left;
}

void lead(Studio& studio, const LessonPicture& wanted) {
    Guide& guide = studio.workbench.guide;
    guide.begin(wanted.lesson, wanted.step, studio.session);
    if (wanted.revealed) {
        guide.reveal(studio.session);
        guide.next(studio.session);  // ends the reveal immediately
    }
    if (wanted.ends) guide.run()->show_end(true);
    if (wanted.presents) studio.workbench.presenter.begin();
    if (!wanted.code_address.empty()) {
        studio.workbench.link_address = wanted.code_address;
        studio.workbench.presenter.show_code();
    }
    studio.workbench.arrangement.has_strip = wanted.has_strip;
    studio.session.finish_loading();
    GrowthViewState& growth = studio.workbench.views.hidden.growth;
    if (wanted.revealed && is_shown(studio.session.params, Topic::growth)) {
        measure_for_stage(growth, studio.session);
        growth.measuring.wait(-1.0);
    }
}

/// Returns the window's sentence for an empty view. If that sentence asks for a click, instead returns one that names
/// the setting that would fill the view.
std::string nothing_to_show(PictureView view, const Params& params, const std::string& offered) {
    const bool wants_pixel = maximized(view) == ViewName::lower_left && examines_pixel(lower_view(params, Slot::left));
    const std::string name = picture_view_names[static_cast<std::size_t>(view)];
    if (wants_pixel && !params.view.pixel && !params.view.pin)
        return "the view " + name + " needs a pinned pixel of the camera's picture: set view.pixel=[X,Y]";
    return "the view " + name + " has nothing to show: " + offered;
}

std::string size_text(glm::ivec2 size_px) {
    return std::to_string(size_px.x) + "x" + std::to_string(size_px.y);
}

/// Returns all that a frame draws, as bytes that can be compared.
std::string bytes_of(const ImDrawData& data) {
    std::string bytes;
    const auto add = [&](const void* from, std::size_t count) { bytes.append(static_cast<const char*>(from), count); };
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        add(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
        add(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
        for (const ImDrawCmd& command : list.CmdBuffer) {
            add(&command.ClipRect, sizeof command.ClipRect);
            add(&command.TextureId, sizeof command.TextureId);
            add(&command.ElemCount, sizeof command.ElemCount);
        }
    }
    return bytes;
}

}  // namespace

void show(Studio& studio, ViewName maximized) {
    const bool is_alone = maximized != ViewName::none;
    studio.workbench.arrangement.maximized = maximized;
    studio.workbench.arrangement.bare = is_alone;
    studio.workbench.widgets.printed = is_alone;
    ImGui::GetIO().MousePos = {-1e6F, -1e6F};
}

RestingWindow::RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                             std::optional<Color> ground)
    : studio_(renderer, Session(state, scene)) {
    if (ground) studio_.set_ground(*ground);
}

Status RestingWindow::settle() {
    std::string last;
    for (int frame = 0; frame < most_frames; ++frame) {
        studio_.frame(surroundings_);
        if (studio_.session.message.is_error) return Error{studio_.session.message.text};
        std::string drawn = bytes_of(*ImGui::GetDrawData());
        if (frame > 1 && drawn == last && studio_.redraw_in_s() != 0.0) break;
        last = std::move(drawn);
    }
    return std::monostate{};
}

Status RestingWindow::rest(const PictureRequest& request) {
    Workbench& workbench = studio_.workbench;
    show(studio_, maximized(request.view));
    if (request.lesson) lead(studio_, *request.lesson);
    if (request.presents && request.view == PictureView::window) workbench.presenter.begin();

    surroundings_ = {.size_px = request.size_px, .device_scale = request.dpi / usual_dpi, .input = {}};
    if (Status settled = settle(); !settled || !workbench.arrangement.bare) return settled;
    if (!workbench.widgets.offered.empty())
        return Error{nothing_to_show(request.view, studio_.session.params, workbench.widgets.offered)};
    return fit();
}

Drawing RestingWindow::sketch() const {
    return recorded(*ImGui::GetDrawData(), [](ImTextureID) { return nullptr; });
}

bool RestingWindow::fits() const {
    return studio_.workbench.widgets.seen_share >= 1.0F && !has_cut_text(sketch());
}

Layout RestingWindow::layout() const {
    return studio_.workbench.layout(ImGui::GetIO().DisplaySize, studio_.session);
}

Status RestingWindow::fit() {
    const glm::ivec2 size_px = surroundings_.size_px;
    const double usual = surroundings_.device_scale;
    double& scale = surroundings_.device_scale;
    // Smaller text needs fewer line breaks, so shrink by at most a tenth at a time.
    while (!fits()) {
        if (scale <= least_size * usual) return Error{too_small(size_px)};
        const double seen = static_cast<double>(studio_.workbench.widgets.seen_share);
        scale = std::max(least_size * usual, scale * std::clamp(seen, 0.9, 0.97));
        if (Status settled = settle(); !settled) return settled;
    }
    // Enlarge content that leaves space, as long as it still fits.
    for (double used = studio_.workbench.widgets.used_share;
         used > 0.0 && used < full_share && scale < most_size * usual; used = studio_.workbench.widgets.used_share) {
        const double before = scale;
        const std::size_t letters = letter_count(sketch());
        scale = std::min(most_size * usual, scale * std::clamp(full_share / used, 1.05, 1.3));
        if (Status settled = settle(); !settled) return settled;
        // Undo an enlargement that makes a view drop a column.
        if (fits() && letter_count(sketch()) >= letters) continue;
        scale = before;
        return settle();
    }
    return std::monostate{};
}

std::string RestingWindow::too_small(glm::ivec2 size_px) {
    const std::string told = "the view does not fit in " + size_text(size_px) + " pixels, even at its smallest scale; ";
    constexpr int highest_px = 8192;
    while (!fits() && surroundings_.size_px.y < highest_px) {
        // If content is cut off without scrolling, the hidden fraction is unknown, so assume at least a fifth.
        const double seen = std::min(static_cast<double>(studio_.workbench.widgets.seen_share), 0.8);
        surroundings_.size_px.y =
            std::min(highest_px, static_cast<int>(std::ceil(surroundings_.size_px.y / seen / 10.0)) * 10);
        if (!settle()) break;
    }
    return fits() ? told + "it fits in " + size_text(surroundings_.size_px) : told + "it needs more width";
}

Drawing RestingWindow::record() {
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    studio_.frame(surroundings_);
    return studio_.record();
}

std::vector<SeenText> RestingWindow::texts() {
    widgets::Context& context = studio_.workbench.widgets;
    context.record = true;
    studio_.frame(surroundings_);
    std::vector<SeenText> texts;
    for (const Mark& mark : sketch().marks) {
        const Line* const line = std::get_if<Line>(&mark.what);
        if (!line) continue;
        SeenText seen{"",
                      "the window",
                      line->lefts_px.front(),
                      line->lefts_px.back() + 0.5F * line->em_px,
                      line->baseline_px,
                      line->em_px};
        for (const char32_t character : line->characters) seen.text += utf8(character);
        const Rect* place = nullptr;
        Rect smallest;
        const ImVec2 middle{0.5F * (seen.left_px + seen.right_px), seen.baseline_px - 0.3F * line->em_px};
        for (const widgets::RecordedItem& item : context.recorded) {
            const Rect rect{item.min, item.max};
            if (!rect.contains(middle) || item.label.empty()) continue;
            if (place && rect.width() * rect.height() >= smallest.width() * smallest.height()) continue;
            smallest = rect;
            place = &smallest;
            seen.place = item.label;
        }
        if (!place) seen.place += " at " + size_text({static_cast<int>(middle.x), static_cast<int>(middle.y)});
        texts.push_back(std::move(seen));
    }
    return texts;
}

Topic topic_of(PictureView view, const Params& params) {
    if (view == PictureView::derivation)
        return is_shown(params, Topic::mirror_derivation) ? Topic::mirror_derivation : Topic::shadow_derivation;
    if (view < PictureView::observer || view == PictureView::matrices) return Topic::automatic;
    const std::string_view name = picture_view_names[static_cast<std::size_t>(view)];
    const std::span<const char* const> topics = names_of<Topic>();
    return static_cast<Topic>(std::find(topics.begin(), topics.end(), name) - topics.begin());
}

}  // namespace viewing
