// The list of the lower views' entries, and the entries of those views whose own sources do not know ViewState. See
// ui/views/lower_view.h.
#include <array>
#include <cfloat>
#include <vector>

#include "text/catalogue.h"
#include "topics/depth/shown/cell_bar.h"
#include "topics/depth/shown/depth_views.h"
#include "topics/depth/shown/fighting_view.h"
#include "topics/depth/shown/pixel_view.h"
#include "topics/depth/shown/precision_view.h"
#include "topics/matrices/shown/display_code_view.h"
#include "topics/planes/shown/derivation_views.h"
#include "topics/planes/shown/lecture_code_view.h"
#include "topics/planes/shown/mirror_ways_view.h"
#include "topics/planes/shown/passes_view.h"
#include "topics/why/shown/why_view.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

/// Draws the tree's legend, in the longest form that fits.
void tree_legend(float right) {
    static constexpr const char* legends[] = {
        marked("color: the polygon's color · + front, − back · small number: traversal order · thick: the eye's side"),
        marked("+ front, − back · small number: traversal order · thick: the eye's side"),
        marked("+ front, − back · thick: the eye's side"), marked("+ front, − back")};
    const float left = ImGui::GetCursorScreenPos().x;
    const ImFont* font = widgets::CurrentContext().fonts.note;
    for (const char* legend : legends) {
        if (left + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, tr(legend)).x > right) continue;
        header_note(legend, right);
        return widgets::Tooltip(
            "How to read the tree",
            (std::string(tr(legends[0])) + "\n" +
             tr("The tree does not depend on the eye, although the slide's \"according to the viewer direction\" may "
                "suggest that it does. The tree is built once, and only its traversal depends on the eye."))
                .c_str());
    }
}

/// Draws the view from the light, with a sentence over the picture.
void draw_light_view(const Derived& derived, const Rect& rect, ImTextureID picture) {
    picture_item("light view", rect, picture);
    const char* whole =
        tr("the light's view: true shadows hide behind their casters, so any shadow seen here is false");
    const char* brief = tr("any shadow seen here is false");
    if (derived.chosen_shadow().light_in_plane) {
        whole = tr("the light lies in the plane and sees it edge-on: there is no shadow");
        brief = tr("there is no shadow");
    }
    sentence_over_picture(ImGui::GetWindowDrawList(), rect, palette().light, whole, brief);
}

/// The last item must be another picture from the same camera. If the pointer is over it, reports the corresponding
/// pixel of the camera's picture. A click pins that pixel if a view shows pinned pixels.
void point_at_camera(ViewState& state, Params& params, const Rect& rect) {
    if (!ImGui::IsItemHovered()) return;
    state.hovered_pixel = camera_pixel_at(rect, ImGui::GetIO().MousePos, state.camera_px, params.projection);
    if (!state.hovered_pixel) return;
    state.told_pixel = state.hovered_pixel;
    if (examines_pixel(params) && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        pin(params, state.pinned, *state.hovered_pixel);
}

}  // namespace

namespace lower_views {

const LowerView depth{
    .title = marked("Depth buffer"),
    .draw =
        [](const FrameContext& frame) {
            draw_depth_picture(frame.session, frame.derived, frame.rect, frame.picture);
            point_at_camera(frame.state, frame.session.params, frame.rect);
        },
    .picture = LowerPicture::depth_buffer,
};

const LowerView histogram{
    .title = marked("Depth histogram"),
    .draw =
        [](const FrameContext& frame) {
            draw_histogram_view(frame.session, frame.derived, frame.pictures.depth.depth_counts, frame.rect);
        },
    .reads_histogram = true,
};

const LowerView precision{
    .title = marked("Depth precision"),
    .draw =
        [](const FrameContext& frame) {
            const auto& pixel = frame.pictures.depth.pixel;
            draw_precision_view(frame.session, frame.derived, frame.rect, pixel ? -pixel->eye_z : 0.0);
        },
    .least_size = {400.0F, 150.0F},
    .lowest = 135.0F,
    .reads_pixel = true,
};

const LowerView codes{
    .title = marked("Depth codes"),
    .draw = [](const FrameContext& frame) { draw_codes_view(frame.session, frame.derived, frame.rect); },
    .least_size = {400.0F, 180.0F},
};

const LowerView pixel{
    .title = marked("Pixel"),
    .draw =
        [](const FrameContext& frame) {
            draw_pixel_view(frame.session, frame.derived, frame.pictures.depth, frame.state.pinned, frame.rect);
        },
    .least_size = {440.0F, 150.0F},
    .reads_pixel = true,
    .reads_fragments = true,
};

const LowerView cells{
    .title = marked("Pixel grid"),
    .draw =
        [](const FrameContext& frame) {
            auto& chosen = frame.session.params.view.cells;
            if (const float width = px(84.0F);
                widgets::Offers("control:view.cells") && ImGui::GetCursorScreenPos().x + width <= frame.rect.max.x)
                choose_cells(chosen, width);
            frame.state.cells = cell_block_size(frame.rect, chosen);
            draw_cell_view(frame.session, frame.pictures.depth, frame.plan, frame.rect, frame.state.call_player);
        },
    .least_size = {440.0F, 150.0F},
    .reads_pixel = true,
    .reads_cells = true,
};

const LowerView fighting{
    .title = marked("Depth fighting"),
    .draw =
        [](const FrameContext& frame) {
            draw_fighting_view(frame.session, frame.pictures.depth.fighting.get(), frame.rect);
        },
    .least_size = {440.0F, 185.0F},
    .lowest = 158.0F,
    .counts_fighting = true,
};

const LowerView passes{
    .title = marked("GL calls, pass by pass"),
    .draw =
        [](const FrameContext& frame) {
            draw_passes_view(frame.session, frame.plan, frame.rect, frame.pictures.passes, frame.derived.aspect,
                             frame.state.pass_player);
        },
    .picture = LowerPicture::after_pass,
    .least_size = {440.0F, 380.0F},
    .lowest = 200.0F,
};

const LowerView tree{
    .title = marked("BSP tree"),
    .draw =
        [](const FrameContext& frame) {
            HiddenState& hidden = frame.state.hidden;
            tree_legend(frame.rect.max.x);
            draw_tree_view(hidden.tree, hidden.links, frame.session, frame.pictures.hidden, frame.rect);
        },
    .least_size = {400.0F, 280.0F},
};

const LowerView order{
    .title = marked("Drawing order"),
    .draw =
        [](const FrameContext& frame) {
            HiddenState& hidden = frame.state.hidden;
            draw_order_view(hidden.order, hidden.links, frame.session, frame.pictures.hidden, frame.rect);
        },
};

const LowerView growth{
    .title = marked("Cost growth"),
    .draw = [](const FrameContext& frame) { draw_growth_view(frame.state.hidden.growth, frame.session, frame.rect); },
};

const LowerView shadow_derivation{
    .title = marked("Shadow derivation"),
    .draw =
        [](const FrameContext& frame) {
            draw_shadow_derivation(frame.session, frame.derived, frame.rect, frame.state.derivation_player);
        },
    .least_size = {440.0F, 320.0F},
    .lowest = 255.0F,
    .has_derivation = true,
};

const LowerView mirror_derivation{
    .title = marked("Mirror derivation"),
    .draw =
        [](const FrameContext& frame) {
            draw_mirror_derivation(frame.session, frame.derived, frame.rect, frame.state.derivation_player);
        },
    .least_size = {440.0F, 320.0F},
    .lowest = 255.0F,
    .has_derivation = true,
};

const LowerView lecture_code{
    .title = marked("The lecture's code"),
    .draw = [](const FrameContext& frame) { draw_lecture_code(frame.session, frame.derived, frame.rect); },
    .least_size = {440.0F, 320.0F},
    .lowest = 230.0F,
    .target = "code:lecture",
    .wants_matrices = true,
};

const LowerView mirror_ways{
    .title = marked("Mirror, four ways"),
    .draw =
        [](const FrameContext& frame) { draw_mirror_ways_view(frame.session, frame.rect, frame.pictures.mirror_ways); },
    .picture = LowerPicture::mirror_ways,
    .least_size = {440.0F, 260.0F},
    .lowest = 190.0F,
};

const LowerView from_light{
    .title = marked("Seen from the light"),
    .draw = [](const FrameContext& frame) { draw_light_view(frame.derived, frame.rect, frame.picture); },
    .camera = [](const Params&, const Derived& derived, const Scene& scene,
                 const Rect& rect) { return derive_light_view(derived, scene, {rect.size_px()}); },
};

const LowerView display_code{
    .title = marked("The lecture's display()"),
    .draw = [](const FrameContext& frame) { draw_display_code_view(frame.session.params, frame.derived, frame.rect); },
    .least_size = {440.0F, 230.0F},
};

const LowerView why{
    .title = marked("Why this pixel?"),
    .draw =
        [](const FrameContext& frame) {
            draw_why_view(frame.state.why, frame.session, frame.state.pinned, frame.rect);
        },
    .least_size = {440.0F, 370.0F},
    .lowest = 340.0F,
    .reads_pixel = true,
    .explains_pixel = true,
};

constexpr std::array all{VIEWING_LOWER_VIEWS(VIEWING_ADDRESS, VIEWING_ADDRESS)};

}  // namespace lower_views

const LowerView& lower_view(Topic topic) {
    return *lower_views::all[static_cast<std::size_t>(topic) - 1];
}

std::span<const char* const> topic_titles() {
    static const std::vector<const char*> titles = [] {
        std::vector<const char*> found{marked("Automatic")};
        for (const LowerView* const view : lower_views::all) found.push_back(view->title);
        return found;
    }();
    return titles;
}

}  // namespace viewing
