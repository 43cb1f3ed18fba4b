#include "topics/camera/shown/way_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "text/words.h"
#include "topics/camera/numbers/camera_way.h"
#include "topics/camera/numbers/clip_space.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/views/lower_view.h"
#include "ui/views/outside.h"

namespace viewing {
namespace {

/// Returns the step that view.way is in, counted from 1; 0 in world space.
int step_of(double way) {
    return std::clamp(static_cast<int>(std::ceil(way)), 0, way_steps);
}

/// A piece of text in one color.
struct Run {
    std::string text;
    widgets::Role role;
};
using Row = std::vector<Run>;

/// Returns the numbers as strings of equal length, for a column.
std::array<std::string, 4> column_text(const glm::dvec4& column, int decimals) {
    std::array<std::string, 4> texts;
    std::size_t longest = 0;
    for (int row = 0; row < 4; ++row) {
        texts[row] = number_text(column[row], decimals);
        longest = std::max(longest, character_count(texts[row]));
    }
    for (std::string& text : texts) text.insert(0, longest - character_count(text), ' ');
    return texts;
}

/// Adds the columns of a matrix, or a single vector, to the four rows, in brackets: "[a b c d]".
void add_columns(std::array<Row, 4>& rows, std::span<const glm::dvec4> columns, widgets::Role role, int decimals) {
    std::array<std::string, 4> texts{"[", "[", "[", "["};
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::array<std::string, 4> numbers = column_text(columns[column], decimals);
        for (std::size_t row = 0; row < 4; ++row) texts[row] += (column > 0 ? " " : "") + numbers[row];
    }
    for (std::size_t row = 0; row < 4; ++row) rows[row].push_back({texts[row] + "]", role});
}

void add_text(std::array<Row, 4>& rows, std::size_t row, const std::string& text) {
    for (std::size_t other = 0; other < 4; ++other)
        rows[other].push_back({other == row ? text : std::string(character_count(text), ' '), widgets::Role::none});
}

/// One step on a point's way through the spaces: the matrix that maps the point, and its coordinates before and after.
struct Carried {
    glm::dmat4 matrix{1.0};
    glm::dvec4 before{0.0}, after{0.0};
};

Carried carried(int step, const Derived& derived, const CameraWay& way, glm::ivec2 window_px) {
    const glm::dvec4 point(derived.followed ? derived.followed->point_world : glm::dvec3(0.0), 1.0);
    const glm::dvec4 view(way.point_view, 1.0), ndc(way.point_ndc.value_or(glm::dvec3(0.0)), 1.0);
    if (step == 1) return {derived.view_from_world, point, view};
    if (step == 2) return {derived.clip_from_view, view, way.point_clip};
    const glm::dmat4 window = window_from_ndc(glm::dvec2(window_px), derived.clip_zero_to_one);
    return {window, ndc, window * ndc};
}

/// Returns the four rows of the step: the matrix, or the division by w, with the point if one is followed.
std::array<Row, 4> rows_of(int step, const Derived& derived, const CameraWay& way, glm::ivec2 window_px, int decimals) {
    using widgets::Role;
    std::array<Row, 4> rows;
    const bool has_point = derived.followed.has_value();
    if (step == 0) {
        if (!has_point) return rows;
        add_text(rows, 1, "p = ");
        const glm::dvec4 point(derived.followed->point_world, 1.0);
        add_columns(rows, {&point, 1}, Role::point, decimals);
        return rows;
    }
    if (step == 3) {
        static constexpr const char* names[] = {"x", "y", "z", "w"};
        for (std::size_t row = 0; row < 4; ++row) rows[row].push_back({std::string(names[row]) + " ÷ w", Role::camera});
        if (!has_point) return rows;
        const std::array<std::string, 4> clip = column_text(way.point_clip, decimals);
        for (std::size_t row = 0; row < 4; ++row)
            rows[row].push_back({" = " + clip[row] + " ÷ " + number_text(way.point_clip.w, decimals), Role::none});
        if (!way.point_ndc) return rows;
        add_text(rows, 1, " = ");
        const glm::dvec4 ndc(*way.point_ndc, 1.0);
        add_columns(rows, {&ndc, 1}, Role::point, decimals);
        return rows;
    }
    const Carried now = carried(step, derived, way, window_px);
    const glm::dvec4 columns[] = {now.matrix[0], now.matrix[1], now.matrix[2], now.matrix[3]};
    add_columns(rows, columns, step == 4 ? Role::none : Role::camera, decimals);
    if (!has_point || (step == 4 && !way.point_ndc)) return rows;
    add_text(rows, 1, " ");
    add_columns(rows, {&now.before, 1}, Role::none, decimals);
    add_text(rows, 1, " = ");
    add_columns(rows, {&now.after, 1}, Role::point, decimals);
    return rows;
}

constexpr float row_height = 1.15F;  ///< relative to the type size

float width_of_row(const Row& row, float size) {
    const ImFont* const font = widgets::CurrentContext().fonts.matrix;
    float width = 0.0F;
    for (const Run& run : row) width += font->CalcTextSizeA(size, FLT_MAX, 0.0F, run.text.c_str()).x;
    return width;
}

/// Returns the type size at which the rows fit the rectangle: at most 1.4 times that of matrices.
float fitting_size(const Rect& rect, const std::array<Row, 4>& rows) {
    constexpr float most = 1.4F;
    const float usual = widgets::CurrentContext().fonts.matrix->FontSize;
    float widest = 1.0F;
    for (const Row& row : rows) widest = std::max(widest, width_of_row(row, usual));
    return std::floor(std::min(
        {most * usual, usual * rect.width() / widest, rect.height() / (row_height * static_cast<float>(rows.size()))}));
}

/// Draws the rows in the middle of the rectangle.
void draw_rows(ImDrawList* draw, const Rect& rect, const std::array<Row, 4>& rows) {
    const widgets::Context& context = widgets::CurrentContext();
    const ImFont* const font = context.fonts.matrix;
    const float size = fitting_size(rect, rows), height = row_height * size * static_cast<float>(rows.size());
    ImVec2 at(rect.min.x, std::floor(rect.min.y + 0.5F * (rect.height() - height)));
    for (const Row& row : rows) {
        at.x = std::floor(rect.min.x + 0.5F * std::max(rect.width() - width_of_row(rows[1], size), 0.0F));
        for (const Run& run : row) {
            draw->AddText(font, size, at, context.palette.of(run.role), run.text.c_str());
            at.x += font->CalcTextSizeA(size, FLT_MAX, 0.0F, run.text.c_str()).x;
        }
        at.y += row_height * size;
    }
}

/// Returns the clip-space condition for points outside a plane, such as "z < −w"; for `none`, the condition for points
/// inside all planes.
const char* condition_of(FrustumPlane plane, bool zero_to_one) {
    static constexpr auto conditions =
        per_enum<FrustumPlane>("−w ≤ x, y, z ≤ w", "z < −w", "z > w", "x < −w", "x > w", "y < −w", "y > w");
    if (zero_to_one && plane == FrustumPlane::none) return "−w ≤ x, y ≤ w, 0 ≤ z ≤ w";
    // Reversed depth: near is at z = w, far at z = 0.
    if (zero_to_one && plane == FrustumPlane::near) return "z > w";
    if (zero_to_one && plane == FrustumPlane::far) return "z < 0";
    return conditions[plane];
}

struct Said {
    std::string whole, brief;
    bool is_trouble = false;
};

Said said(int step, const Derived& derived, const CameraWay& way, bool is_logarithmic) {
    if (!derived.followed) return {tr("click a vertex of an object to follow it"), tr("click a vertex"), false};
    const bool is_cut = step >= 2 && way.cut_by != FrustumPlane::none;
    if (is_cut) {
        const std::string told = say("{outcome}: {condition}", "outcome"_a = tr(outcome_of(way.cut_by)),
                                     "condition"_a = condition_of(way.cut_by, derived.clip_zero_to_one));
        return {told, told, true};
    }
    switch (step) {
        case 0:
            return {tr("world space: where the scene puts p"), tr("world space"), false};
        case 1:
            return {tr("V maps p to eye space: the camera is at the origin"), tr("V maps p to eye space"), false};
        case 2:
            return {say("P maps it to clip space, inside if {condition}",
                        "condition"_a = condition_of(FrustumPlane::none, derived.clip_zero_to_one)),
                    tr("P maps it to clip space"), false};
        case 3:
            return {tr("the division by w maps it to NDC: the frustum is a box"), tr("÷ w maps it to NDC"), false};
        default:
            if (is_logarithmic)
                return {tr("the viewport maps it to the window; then the shader replaces z with the logarithm"),
                        tr("the viewport: pixels"), false};
            return {tr("the viewport maps it to the window, in pixels"), tr("the viewport: pixels"), false};
    }
}

/// Returns the label of the point.
std::string label_of_point(double way, const CameraWay& camera, glm::ivec2 window_px) {
    static constexpr const char* names[] = {"p", "V p", "P V p", "P V p ÷ w"};
    if (way != std::floor(way)) return "p";
    if (way < 4.0) return names[static_cast<std::size_t>(way)];
    if (camera.cut_by != FrustumPlane::none || !camera.point_ndc) return "P V p ÷ w";
    const glm::dvec2 place =
        (0.5 + 0.5 * glm::dvec2(camera.point_ndc->x, -camera.point_ndc->y)) * glm::dvec2(window_px);
    const glm::ivec2 pixel = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), window_px - 1);
    return say("pixel ({x}, {y})", "x"_a = pixel.x, "y"_a = pixel.y);
}

void play_button(Params& params, widgets::StepPlayer& player) {
    if (ImGui::Button(player.playing ? "■##play" : "▶##play", {ImGui::GetFrameHeight() * 1.2F, 0.0F})) {
        player = {.playing = !player.playing};
        if (player.playing && params.view.way >= way_steps) params.view.way = 0.0;
    }
    widgets::Record("play");
    widgets::Tooltip(player.playing ? marked("Stop") : marked("Play"),
                     player.playing ? marked("Stops the point where it is.")
                                    : marked("Moves the point from space to space; at the end, starts over."));
}

/// Draws the play button and the slider from the world to the window.
void way_bar(ViewState& state, Params& params, const Rect& row) {
    widgets::StepPlayer& player = state.way_player;
    play_way(params.view.way, player, ImGui::GetIO().DeltaTime, state.moves);
    ImGui::SetCursorScreenPos({row.min.x + px(8.0F), row.min.y + px(4.0F)});
    play_button(params, player);
    player.shown = true;
    const double before = params.view.way;
    slider_between(params, "view.way", {{ImGui::GetItemRectMax().x, row.min.y}, row.max}, tr("world"), tr("pixels"));
    if (params.view.way != before) player.playing = false;
    if (player.playing) widgets::AskForRedraw(0.0F);
}

}  // namespace

WayPlaces way_places(const Rect& rect) {
    constexpr float wide = 2.7F, column = 0.58F, lines = 0.27F, bar = 0.14F;
    if (rect.width() >= wide * rect.height()) {
        const float middle = std::floor(rect.max.x - column * rect.width());
        const float low = std::floor(rect.max.y - bar * rect.height());
        return {{rect.min, {middle, low}}, {{middle, rect.min.y}, {rect.max.x, low}}};
    }
    const float low = std::floor(rect.max.y - bar * rect.height());
    const float middle = std::floor(low - lines * rect.height());
    return {{rect.min, {rect.max.x, middle}}, {{rect.min.x, middle}, {rect.max.x, low}}};
}

Edges free_of_numbers(const Rect& rect) {
    const Rect free = way_places(rect).picture;
    const auto across = [&](float x) { return 2.0 * (x - rect.min.x) / rect.width() - 1.0; };
    const auto up = [&](float y) { return 1.0 - 2.0 * (y - rect.min.y) / rect.height(); };
    return {across(free.min.x), across(free.max.x), up(free.max.y), up(free.min.y)};
}

void play_way(double& way, widgets::StepPlayer& player, double dt_s, bool moves) {
    constexpr double rest_s = 1.0, move_s = 1.6;
    if (!player.playing || !(dt_s > 0.0)) return;
    double& waited_s = player.carry_steps;
    const bool is_at_space = way == std::floor(way);
    waited_s += dt_s;
    const double due_s = moves ? rest_s : rest_s + move_s;
    if (is_at_space && waited_s < due_s) return;
    const double next = std::floor(way) + 1.0;
    const double moved_s = is_at_space ? waited_s - due_s : dt_s;
    way = moves ? std::min(way + std::max(moved_s, 1e-6) / move_s, next) : next;
    if (way == next || !is_at_space) waited_s = 0.0;
    if (way < way_steps) return;
    way = way_steps;
    player.playing = false;
}

namespace {

void draw_way_view(const FrameContext& frame) {
    const auto& [state, session, derived, plan, pictures, rect, picture] = frame;
    const widgets::Group group("way");
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    // The slider and the button are submitted before the picture, so that they get the mouse input, but are drawn on
    // top of it.
    draw->ChannelsSplit(2);
    draw->ChannelsSetCurrent(1);
    Params& params = session.params;
    const Rect row = slider_row(rect, "view.way");
    if (!row.empty()) way_bar(state, params, row);
    draw->ChannelsSetCurrent(0);
    picture_item("lower view", rect, picture);

    const glm::ivec2 window_px = glm::max(state.camera_px, 1);
    const int step = step_of(params.view.way);
    const CameraWay way = derived.followed ? camera_way(params, derived, derived.followed->point_world) : CameraWay{};
    {
        const ObserverView view = derive_way_view(params, derived, {rect.size_px()}, free_of_numbers(rect));
        const WayPlaces places = way_places(rect);
        Overlay overlay(draw, rect, view.clip_from_world);
        const bool is_over_point = point_or_observer_mouse(state, session, derived, overlay);
        if (step <= 1) world_axes(overlay);
        draw_frustum(overlay, params, derived, effective_camera(derived));
        if (derived.followed) {
            const std::string label = label_of_point(params.view.way, way, window_px);
            draw_point_on_ray(overlay, params, derived, label.c_str());
            if (is_over_point) overlay.ring(derived.followed->point_world, palette().point, 9.0F);
            if (step >= 2) mark_cutting_face(overlay, params, derived);
        }
        const Rect numbers{places.numbers.min, {places.numbers.max.x, row.min.y}};
        draw->AddRectFilled(numbers.min, numbers.max, palette().view_ground);
        overlay.keep_labels_off(numbers);
        overlay.keep_labels_off(row);
        const bool is_covered = widgets::IsPartCovered("matrix:V") || widgets::IsPartCovered("matrix:P");
        const float margin = px(8.0F);
        const Rect inner{{numbers.min.x + margin, numbers.min.y + 0.5F * margin},
                         {numbers.max.x - margin, numbers.max.y - 0.5F * margin}};
        if (!is_covered) {
            const std::array<Row, 4> exact = rows_of(step, derived, way, window_px, 3);
            const bool is_small = fitting_size(inner, exact) < px(11.0F);
            draw_rows(draw, inner, is_small ? rows_of(step, derived, way, window_px, 2) : exact);
        }
        const Said told = said(step, derived, way, params.depth.mapping == DepthMapping::logarithmic);
        overlay.keep_labels_off(sentence_over_picture(
            draw, places.picture, told.is_trouble && !is_covered ? palette().trouble : palette().camera,
            told.whole.c_str(), told.brief.c_str()));
    }
    draw->ChannelsMerge();
}

}  // namespace

const LowerView lower_views::way{
    .title = marked("The path of a point"),
    .draw = draw_way_view,
    .camera =
        [](const Params& params, const Derived& derived, const Scene&, const Rect& rect) {
            return derive_way_view(params, derived, {rect.size_px()}, free_of_numbers(rect));
        },
    .turns = true,
};

}  // namespace viewing
