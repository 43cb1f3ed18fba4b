#include "topics/matrices/shown/matrices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "frame/matrix_facts.h"
#include "geometry/camera.h"
#include "text/catalogue.h"
#include "topics/matrices/shown/display_code_view.h"
#include "topics/matrices/shown/followed_point.h"
#include "topics/matrices/shown/shown_matrix.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

using widgets::Role;

/// The data of the column: the state, and the derived numbers now and before the latest edit.
struct Column {
    Session& session;
    const Derived& derived;
    const Derived& before;
    bool has_symbols = true;  ///< shows symbols below the numbers
    char& pastes;             ///< receives the letter of the matrix to replace by pasting

    MatrixCells shown(MatrixCells cells) const {
        const bool are_covered = widgets::IsCovered("symbols");
        for (widgets::MatrixCell& cell : cells)
            if (!has_symbols || (are_covered && *cell.symbol != '\0')) cell.symbol = has_symbols ? "?" : "";
        return cells;
    }
};

/// Says how far the matrix moves points on the plane: "points on the plane stay ± 0" or "points on the plane move by up
/// to 0.25".
std::string moved_text(const glm::dmat4& matrix, const PlanePatch& patch) {
    double moved = 0.0;
    for (const glm::dvec3& corner : patch.corners()) {
        const glm::dvec4 sent = matrix * glm::dvec4(corner, 1.0);
        if (std::abs(sent.w) < 1e-12) return tr("points on the plane go to infinity");
        moved = std::max(moved, glm::length(glm::dvec3(sent) / sent.w - corner));
    }
    if (moved > 1e-3) return say("points on the plane move by up to {distance}", "distance"_a = number_text(moved, 3));
    return identity_text(tr("points on the plane stay"), moved);
}

/// Draws a list from which to choose "plane 1", "plane 2", …; `number` is counted from 1.
void choose_one(const char* name, int& number, std::size_t count) {
    if (count == 1) return;
    std::vector<std::string> texts;
    std::vector<const char*> names;
    for (std::size_t i = 0; i < count; ++i)
        texts.push_back(say("{thing} {number}", "thing"_a = tr(name), "number"_a = i + 1));
    for (const std::string& text : texts) names.push_back(text.c_str());
    int chosen = number - 1;
    ImGui::SameLine(0.0F, px(8.0F));
    if (widgets::Choice((std::string("##") + name).c_str(), chosen, names, 0)) number = chosen + 1;
    explain(field(std::string("view.") + name), name);
}

void choose_pair(Params& params) {
    if (params.planes.size() == 1 && params.lights.size() == 1) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("S and R for"));
    choose_one(marked("plane"), params.view.plane, params.planes.size());
    choose_one(marked("light"), params.view.light, params.lights.size());
}

constexpr const char* shadow_facts[] = {"fact:det_shadow", "fact:rank_shadow", "fact:plane_dot_light"};
constexpr const char* mirror_facts[] = {"fact:det_mirror"};

/// Returns a fact about S: the determinant or Π·L if a lesson highlights it, since the usual facts only imply it.
std::string shadow_fact(const glm::dmat4& shadow, const CastShadow& cast) {
    const std::string identity = identity_text("S² = (Π·L)S", shadow_residual(shadow, cast.plane_dot_light));
    if (widgets::IsHighlighted("fact:det_shadow")) return "det S = " + number_text(glm::determinant(shadow), 3);
    if (widgets::IsHighlighted("fact:plane_dot_light")) return "Π·L = " + number_text(cast.plane_dot_light, 3);
    return say("rank {rank} · {identity}", "rank"_a = rank_of(shadow), "identity"_a = identity);
}

/// Returns the note on S, whose entries are shown: a fact, and whether −S is uploaded instead.
std::string shadow_note(const glm::dmat4& shadow, const CastShadow& cast) {
    const std::string fact = shadow_fact(shadow, cast);
    if (cast.sign >= 0.0 || widgets::IsCovered("fact:plane_dot_light")) return fact;
    return say("{fact} · −S is uploaded", "fact"_a = fact);
}

/// S and R of the chosen plane and light, and their values before the latest edit. Choosing another pair does not count
/// as an edit.
struct ChosenPair {
    explicit ChosenPair(const Column& column)
        : plane(column.derived.chosen_plane()), cast(column.derived.chosen_shadow()) {
        const auto [plane_index, light_index] = column.derived.chosen;
        const Derived& before = column.before;
        const bool was_there = plane_index < before.planes.size() && light_index < before.lights_world.size();
        plane_before = was_there ? &before.planes[plane_index] : &plane;
        cast_before = was_there ? &plane_before->shadows[light_index] : &cast;
    }
    const DerivedPlane& plane;
    const CastShadow& cast;
    const DerivedPlane* plane_before;
    const CastShadow* cast_before;
};

void show_shadow(const Column& column) {
    const ChosenPair pair(column);
    const auto& [plane, cast, plane_before, cast_before] = pair;
    const auto [plane_index, light_index] = column.derived.chosen;
    const glm::dmat4& shadow = cast.shadowed_world_from_world;
    show_overridable(
        {marked("Shadow"), "S", "shadow_from_world",
         marked("S = (Π·L) I − L Πᵀ with the plane Π scaled to a unit normal. S flattens every point along the ray "
                "from the light, so the determinant of S is 0. The uploaded matrix is sign(Π·L) · S: the same "
                "map, but the factor in front makes w > 0, so the clipper keeps the shadow."),
         Role::light, shadow, cast_before->shadowed_world_from_world,
         column.shown(shadow_cells(column.session.params.slips.shadow_by_rows)), shadow_roles(),
         shadow_matrix(plane.unit_plane, cast.light_world), "", moved_text(shadow, plane.patch), shadow_facts},
        shadow_note(shadow, cast), column.session.params.overrides[plane_index].shadowed_world_from_world[light_index],
        column.pastes);
}

void show_mirror(const Column& column) {
    const ChosenPair pair(column);
    const DerivedPlane& plane = pair.plane;
    std::optional<glm::dmat4>& by_hand =
        column.session.params.overrides[column.derived.chosen.plane].mirrored_world_from_world;
    const glm::dmat4& mirror = plane.mirrored_world_from_world;
    const bool by_rows = column.session.params.reflection.printed_by_rows;
    const bool is_transposed = by_rows && !by_hand;
    const std::string determinant = "det " + number_text(glm::determinant(mirror), plane.mirror_has_slip ? 2 : 0);
    const std::string fact = is_transposed           ? tr("as printed")
                             : plane.mirror_has_slip ? say("mistake, {fact}", "fact"_a = determinant)
                                                     : determinant;
    show_overridable(
        {marked("Reflection"), "R", "mirror_from_world",
         marked("R p = p − 2 (n·p + d) n maps every point to its mirror image. R is its own inverse and reverses the "
                "winding."),
         Role::mirror, mirror, pair.plane_before->mirrored_world_from_world,
         column.shown(mirror_cells(by_rows, column.session.params.slips.plus_2ab)), mirror_roles(),
         mirror_matrix(plane.unit_plane), is_transposed ? "Rᵀ" : "R", moved_text(mirror, plane.patch), mirror_facts},
        fact + " · " + identity_text("R² = I", mirror_residual(mirror)), by_hand, column.pastes);
}

/// Draws C and the given buttons; returns whether one was pressed.
bool show_camera(const Column& column, std::span<const char* const> buttons) {
    const bool swapped = column.session.params.slips.swapped_order;
    return show_matrix({marked("Camera"), "C", "world_from_view",
                        marked("The pose of the camera in the world. The columns are right, up, back and the eye."),
                        Role::camera, column.derived.world_from_view, column.before.world_from_view,
                        column.shown(camera_cells(swapped)), camera_roles()},
                       swapped ? tr("C = R_y R_x R_z T (mistake)") : "C = T R_y R_x R_z", buttons, column.pastes);
}

/// Draws V and, unless `button` is null, that button; returns whether the button was pressed.
bool show_view(const Column& column, const char* button) {
    const SlipParams& slips = column.session.params.slips;
    const std::string inverse = identity_text("V C = I", column.derived.facts.view_residual);
    return show_overridable(
        {marked("View"), "V", "view_from_world",
         marked("V = C⁻¹: the world as the camera sees it. Its rows are right, up and back."), Role::camera,
         column.derived.view_from_world, column.before.view_from_world,
         column.shown(slips.camera_as_view ? camera_cells(slips.swapped_order) : view_cells(slips.swapped_order)),
         camera_roles(), view_from_world(placed_camera(column.session.params))},
        slips.camera_as_view ? tr("= C (mistake)") : "= C⁻¹ · " + inverse,
        column.session.params.camera_overrides.view_from_world, column.pastes, button);
}

/// Draws either V or C, which are two ways to look at the camera's movement.
void show_view_or_camera(const Column& column, bool& shows_camera) {
    static constexpr const char* to_view[] = {marked("Show V")};
    if (shows_camera ? show_camera(column, to_view) : show_view(column, marked("Show C"))) shows_camera = !shows_camera;
}

void show_projection(const Column& column) {
    Params& params = column.session.params;
    const Derived& derived = column.derived;
    const auto divided_z = [&](double distance) {
        const glm::dvec4 axis(0.0, 0.0, -1.0, std::isinf(distance) ? 0.0 : 1.0 / distance);
        const glm::dvec4 clip = derived.clip_from_view * (distance == 0.0 ? glm::dvec4(0.0, 0.0, 0.0, 1.0) : axis);
        return figures(clip.z / clip.w);
    };
    const std::string becomes =
        say("P maps view space to clip space; after ÷ w, the near plane is at {near} and the far plane at {far}.",
            "near"_a = divided_z(params.projection.near), "far"_a = divided_z(params.projection.far));
    const std::string aspect =
        number_text(derived.aspect, derived.aspect < 9.995 ? 2 : 1);  // four characters, which fit
    const double fovy_deg = glm::degrees(2.0 * std::atan(1.0 / derived.clip_from_view[1][1]));
    const bool is_widened = column.session.params.projection.fovy + 0.05 < fovy_deg;  // on a narrow stage
    show_overridable(
        {marked("Projection"), "P", "clip_from_view", becomes.c_str(), Role::camera, derived.clip_from_view,
         column.before.clip_from_view, column.shown(projection_cells(params, derived.clip_zero_to_one)), camera_roles(),
         projection_without_hand(params, derived)},
        params.projection.has_window() ? tr(params.projection.is_orthographic() ? marked("glOrtho(l, r, b, t, n, f)")
                                                                                : marked("glFrustum(l, r, b, t, n, f)"))
        : params.projection.is_orthographic() ? say("aspect {aspect}", "aspect"_a = aspect)
        : params.slips.degrees_as_radians
            ? say("c = cot(½ · {fovy} rad) (mistake)", "fovy"_a = number_text(params.projection.fovy, 1))
        : is_widened && !params.camera_overrides.clip_from_view
            ? say("c = cot(½ · {fovy}°), aspect {aspect}", "fovy"_a = number_text(fovy_deg, 1), "aspect"_a = aspect)
            : say("c = cot(½ fovy), aspect {aspect}", "aspect"_a = aspect),
        params.camera_overrides.clip_from_view, column.pastes);
}

/// Draws the slide's display() function with the camera's numbers.
void show_display(const Column& column) {
    const char* const slide = tr("the slide's display()");
    if (!matrix_heading(marked("Camera movement"), "", slide, Role::camera, ImGui::GetContentRegionMax().x))
        widgets::Note(slide);
    if (!widgets::IsPartCovered("code:display"))
        widgets::Tooltip("Moving the camera means moving the world the other way",
                         "The lecture's display() with angles in radians and with pitch and roll added: the product is "
                         "V, so the picture is the same.");
    draw_display_code(column.session.params, column.derived);
}

}  // namespace

std::array<MatrixPart, 4> fit_matrices(float room, const PerEnum<MatrixPart, float, 3>& heights,
                                       std::span<const std::string> first) {
    std::array<MatrixPart, 4> parts{};  // headings alone
    float left = room - 4.0F * heights.front();
    const auto grow = [&](bool is_first, MatrixPart part) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const float cost = heights[part] - heights[parts[i]];
            if (is_named(first, matrices_in_order[i]) != is_first || parts[i] >= part || cost > left) continue;
            left -= cost;
            parts[i] = part;
        }
    };
    grow(true, MatrixPart::numbers);
    grow(true, MatrixPart::symbols);
    grow(false, MatrixPart::numbers);
    if (std::find(parts.begin(), parts.end(), MatrixPart::heading) == parts.end()) grow(false, MatrixPart::symbols);
    return parts;
}

namespace {

/// The heights of a matrix with its heading.
PerEnum<MatrixPart, float, 3> matrix_heights() {
    const float spacing = ImGui::GetStyle().ItemSpacing.y, heading = ImGui::GetFrameHeight() + spacing;
    const auto with = [&](bool has_symbols) {
        return heading + widgets::MatrixHeight(has_symbols) + 2.0F * spacing + px(1.0F);
    };
    return {heading, with(false), with(true)};
}

struct MatrixTitle {
    const char* title;
    Role role;
};

constexpr std::array<MatrixTitle, 4> matrix_titles = {{{marked("View"), Role::camera},
                                                       {marked("Projection"), Role::camera},
                                                       {marked("Shadow"), Role::light},
                                                       {marked("Reflection"), Role::mirror}}};

/// Draws only the heading of a matrix whose numbers do not fit; returns whether the heading was clicked.
bool folded_heading(std::size_t number) {
    const ImVec2 start = ImGui::GetCursorPos();
    const bool is_clicked =
        ImGui::InvisibleButton(matrices_in_order[number], {ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()});
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    const float half = px(4.5F), x = max.x - px(14.0F), y = 0.5F * (min.y + max.y);
    ImGui::GetWindowDrawList()->AddTriangleFilled({x - half, y - half}, {x + half, y}, {x - half, y + half}, color);
    widgets::Record((std::string("open ") + matrices_in_order[number]).c_str());
    const ImVec2 end = ImGui::GetCursorPos();
    ImGui::SetCursorPos(start);
    const MatrixTitle& title = matrix_titles[number];
    matrix_heading(title.title, matrices_in_order[number], "", title.role, ImGui::GetContentRegionMax().x);
    ImGui::SetCursorPos(end);
    return is_clicked;
}

/// Returns the transformations of the followed point to show in a list of matrices.
PointNumbers numbers_in(std::span<const std::string> listed, const Session& session) {
    return point_numbers(listed, session.params.shadow.enabled, session.params.reflection.enabled);
}

constexpr float symbols_padding = 4.0F;  ///< above and below each part of a list that has symbols; design pixels

/// Returns the height of the listed parts, one below the other, if the first `symbolic` matrices have symbols.
/// `growth`: the scale factor of the matrices' heights.
float height_of(std::span<const std::string> listed, std::size_t symbolic, const Session& session,
                float growth = 1.0F) {
    const float padding = symbolic > 0 ? px(symbols_padding) : 0.0F;
    float height = 0.0F;
    std::size_t place = 0;
    for (const std::string& name : listed) {
        height += 2.0F * padding + ImGui::GetStyle().ItemSpacing.y;
        if (is_matrix(name)) {
            const bool has_symbols = place++ < symbolic;
            height += matrix_heights()[has_symbols ? 2 : 1] + (growth - 1.0F) * widgets::MatrixHeight(has_symbols);
        } else {
            height += name == "follow" ? followed_point_height(session, numbers_in(listed, session))
                                       : px(display_code_height);
        }
    }
    return height;
}

/// Returns the number of listed matrices that have space for symbols, first come, first served. Showing all numbers
/// matters more than showing the symbols below them.
std::size_t symbolic_matrices(std::span<const std::string> listed, float room, const Session& session) {
    auto count = static_cast<std::size_t>(std::count_if(listed.begin(), listed.end(), is_matrix));
    while (count > 0 && height_of(listed, count, session) > room) --count;
    return count;
}

/// Returns the scale factor at which the listed matrices fill the column.
float growth_of(std::span<const std::string> listed, std::size_t symbolic, float room, const Session& session) {
    constexpr float largest = 2.75F;
    const float usual = height_of(listed, symbolic, session),
                added = height_of(listed, symbolic, session, 2.0F) - usual;
    return added > 0.0F ? std::clamp(1.0F + (room - usual) / added, 1.0F, largest) : 1.0F;
}

}  // namespace

void draw_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice,
                   std::span<const std::string> about) {
    const widgets::Group group("matrices");
    const float room = ImGui::GetContentRegionAvail().x, least_column = px(340.0F);
    const bool side_by_side = room >= 2.0F * least_column;
    const auto column = [&](const char* name, const auto& draw) {
        if (side_by_side) ImGui::BeginChild(name, {0.5F * (room - px(16.0F)), 0.0F});
        draw();
        if (!side_by_side) return;
        widgets::CountScrolled();
        ImGui::EndChild();
    };
    const float top = ImGui::GetCursorPosY(), height = ImGui::GetWindowHeight();
    const std::vector<std::string> opened{choice.opened};
    const bool has_pair = session.params.planes.size() > 1 || session.params.lights.size() > 1;
    const float others = followed_point_height(session, numbers_in(about, session)) +
                         (has_pair ? ImGui::GetFrameHeightWithSpacing() : 0.0F);
    const PerEnum<MatrixPart, float, 3> heights = matrix_heights();
    std::array<MatrixPart, 4> parts{};
    parts.fill(MatrixPart::symbols);
    if (!side_by_side)
        parts = fit_matrices(ImGui::GetContentRegionAvail().y - others, heights,
                             choice.opened.empty() ? about : std::span<const std::string>(opened));
    const auto show = [&](std::size_t number) {
        if (parts[number] == MatrixPart::heading) {
            if (folded_heading(number)) choice.opened = matrices_in_order[number];
            return;
        }
        const Column shown{session, derived, before, parts[number] == MatrixPart::symbols, choice.pastes};
        switch (*matrices_in_order[number]) {
            case 'V':
                show_view_or_camera(shown, choice.shows_camera);
                break;
            case 'P':
                show_projection(shown);
                break;
            case 'S':
                show_shadow(shown);
                break;
            default:
                show_mirror(shown);
        }
    };
    column("view space", [&] {
        show(0);
        show(1);
        if (side_by_side) show_display({session, derived, before, true, choice.pastes});
    });
    if (side_by_side) ImGui::SameLine(0.0F, px(16.0F));
    column("object space", [&] {
        choose_pair(session.params);
        show(2);
        show(3);
        // Show all numbers of the point if they fit in the column.
        const float used = ImGui::GetCursorPosY() + (side_by_side ? top : 0.0F);
        const bool has_room = used + followed_point_height(session, PointNumbers::both) <= height;
        draw_followed_point(session, derived, has_room ? PointNumbers::both : numbers_in(about, session));
    });
    if (!side_by_side) show_display({session, derived, before, true, choice.pastes});
}

void draw_listed_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice,
                          const std::vector<std::string>& listed) {
    const widgets::Group group("matrices");
    const auto has = [&listed](const char* name) { return is_named(listed, name); };
    if (has("S") || has("R")) choose_pair(session.params);
    const bool has_both = has("V") && has("C");
    bool shows_camera = has("V") ? choice.shows_camera : !choice.shows_camera;
    // Put two matrices side by side if they fit, but never make one too wide to read at a glance.
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = listed.size() > 1 && room >= 2.0F * px(360.0F) ? 2 : 1;
    const float width = std::min(room, static_cast<float>(columns) * px(600.0F));
    const float height = ImGui::GetContentRegionAvail().y;
    // Two columns have as many rows as the first half of the list.
    const auto rows = std::span(listed).first((listed.size() + static_cast<std::size_t>(columns) - 1) /
                                              static_cast<std::size_t>(columns));
    const std::size_t in_rows = symbolic_matrices(rows, height, session);
    const std::size_t symbolic = columns == 1 ? in_rows : in_rows == rows.size() ? listed.size() : 0;
    const float padding = symbolic > 0 ? px(symbols_padding) : 0.0F;
    if (widgets::CurrentContext().is_on_stage && columns == 1)
        widgets::CurrentContext().matrix_growth = growth_of(listed, symbolic, height, session);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {columns > 1 ? px(8.0F) : 0.0F, padding});
    if (ImGui::BeginTable("listed", columns, ImGuiTableFlags_SizingStretchSame, {width, 0.0F})) {
        std::size_t place = 0;
        for (const std::string& name : listed) {
            ImGui::TableNextColumn();
            const Column shown{session, derived, before, is_matrix(name) && place++ < symbolic, choice.pastes};
            const bool is_view = name == "V";
            if (name == "S") show_shadow(shown);
            if (name == "R") show_mirror(shown);
            if (name == "follow") draw_followed_point(session, derived, numbers_in(listed, session));
            if (has_both && is_view) show_view(shown, nullptr);
            if (has_both && name == "C") show_camera(shown, {});
            if (!has_both && (is_view || name == "C")) show_view_or_camera(shown, shows_camera);
            if (name == "P") show_projection(shown);
            if (name == "display") show_display(shown);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    widgets::CurrentContext().matrix_growth = 1.0F;
    choice.shows_camera = has("V") ? shows_camera : !shows_camera;
}

}  // namespace viewing
