#include "ui/matrices/matrices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "frame/matrix_facts.h"
#include "frame/matrix_text.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/matrices/display_code.h"
#include "ui/parts/controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"

namespace viewing {
namespace {

using widgets::Role;

/// How well an identity holds, measured: "S² = (Π·L)S ± 0", "… ± 10⁻¹⁴", "S² ≠ (Π·L)S".
std::string identity_text(const char* identity, double residual) {
    if (residual == 0.0) return std::string(identity) + " ± 0";
    if (residual > 1e-3) {
        std::string broken = identity;
        return broken.replace(broken.find(" = "), 3, " ≠ ");
    }
    const int exponent = static_cast<int>(std::ceil(-std::log10(residual)));
    return std::string(identity) + " ± 10⁻" + raised_text(exponent);
}

/// Where a small button at the right end of a row begins.
float place_at_right(const char* button) {
    return ImGui::GetContentRegionMax().x - std::max(px(52.0F), widgets::SmallButtonWidth(button));
}

/// Of what is covered nothing is copied.
constexpr const char* covered_text = marked("Covered until the answer is given.");

void copy_menu(const char* id, const char* name, const glm::dmat4& matrix, bool is_covered) {
    struct Entry {
        const char* label;
        MatrixFormat format;
    };
    static constexpr Entry entries[] = {{marked("GLM (columns first)"), MatrixFormat::glm},
                                        {marked("GLSL (columns first)"), MatrixFormat::glsl},
                                        {"NumPy", MatrixFormat::numpy},
                                        {"MATLAB", MatrixFormat::matlab},
                                        {"LaTeX", MatrixFormat::latex},
                                        {marked("plain text"), MatrixFormat::text}};
    ImGui::PushID(id);
    ImGui::SameLine(place_at_right("Copy"));
    if (widgets::SmallButton("Copy", !is_covered, covered_text)) ImGui::OpenPopup("copy");
    if (!is_covered) widgets::Tooltip("Copy", "Puts this matrix into the clipboard, with all its digits.");
    if (ImGui::BeginPopup("copy")) {
        widgets::ClosePopupOnEscape();
        for (const Entry& entry : entries) {
            if (ImGui::MenuItem(widgets::LabelText(entry.label).c_str()))
                ImGui::SetClipboardText(matrix_text(name, matrix, entry.format).c_str());
            widgets::Record(entry.label);
        }
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

/// "Shadow S   rank 3 · S² = (Π·L) S" up to `right`. False where the note has no room there and has to stand below.
bool heading(const char* title, const char* letter, const std::string& note, Role role, float right) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.heading);
    ImGui::TextUnformatted(tr(title));
    ImGui::SameLine(0.0F, px(6.0F));
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.of(role));
    ImGui::TextUnformatted(letter);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    const float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + px(10.0F);
    if (left + width_of(note, context.fonts.note) > right) return false;
    ImGui::SameLine(left);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.note);
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.quiet);
    ImGui::TextUnformatted(note.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    return true;
}

/// A matrix with everything around it.
struct Shown {
    const char* title;
    const char* letter;
    const char* name;  ///< as in C++, GLSL and JSON
    const char* explains;
    Role role;
    glm::dmat4 now, before;
    MatrixCells cells;
    std::span<const widgets::LetterRole> roles;
    glm::dmat4 derived{1.0};                  ///< what it would be without an entry by hand
    std::string heading = "";                 ///< in place of the letter
    std::string property = "";                ///< what one by hand should have, and how far it is from that
    std::span<const char* const> facts = {};  ///< what the note tells, by its names for a lesson
};

/// What a fact's name stands for is told, unless it is covered; where it is, the whole note is.
std::string told_fact(const std::string& note, std::span<const char* const> facts) {
    return std::any_of(facts.begin(), facts.end(), widgets::IsCovered) ? "?" : note;
}

void mark_facts(std::span<const char* const> facts) {
    for (const char* fact : facts) widgets::MarkTarget(fact);
}

/// Buttons beside Copy, from the right; returns which one was pressed.
const char* show(Shown shown, const std::string& fact, std::span<const char* const> buttons,
                 std::optional<glm::dmat4>* by_hand = nullptr) {
    const char* pressed = nullptr;
    const std::string target = "matrix:" + std::string(shown.letter);
    const bool is_covered = widgets::IsCovered(target), is_part_covered = widgets::IsPartCovered(target);
    const bool tells_difference = !is_part_covered && !widgets::IsCovered("sentences");
    std::string note = is_covered ? "" : told_fact(fact, shown.facts), explains = tr(shown.explains);
    if (by_hand && is_part_covered) buttons = {};
    if (by_hand && *by_hand && !tells_difference) note = tr("by hand");
    if (by_hand && *by_hand && tells_difference) {
        const double difference = largest_difference_up_to_scale(**by_hand, shown.derived);
        note = say("by hand, off by {difference}", "difference"_a = number_text(difference, 3));
        explains =
            say("By hand: light and plane change nothing here. The largest difference to the right {matrix}, up "
                "to a factor, is {difference}; {property}.",
                "matrix"_a = shown.letter, "difference"_a = number_text(difference, 3), "property"_a = shown.property);
    }
    ImGui::PushID(shown.name);
    mark_changed(shown.cells, shown.now, shown.before);
    const auto room_of = [](const char* button) { return widgets::SmallButtonWidth(button) + px(4.0F); };
    float end = place_at_right("Copy") - px(4.0F);
    for (const char* button : buttons) end -= room_of(button);
    const bool has_note =
        heading(shown.title, shown.heading.empty() ? shown.letter : shown.heading.c_str(), note, shown.role, end);
    if (has_note) mark_facts(shown.facts);
    if (tells_difference) widgets::Tooltip(shown.name, explains.c_str());
    float right = place_at_right("Copy") - px(4.0F);
    for (const char* button : buttons) {
        right -= room_of(button);
        ImGui::SameLine(right);
        if (widgets::SmallButton(button)) pressed = button;
    }
    copy_menu(shown.name, shown.name, shown.now, is_part_covered);
    if (!has_note) {
        widgets::Note(note.c_str());
        mark_facts(shown.facts);
        if (tells_difference) widgets::Tooltip(shown.name, explains.c_str());
    }
    if (by_hand && *by_hand) {
        for (widgets::MatrixCell& cell : shown.cells) cell.links = cell.own = 0;
        const widgets::MatrixStyle style{.cells = shown.cells,
                                         .editable = true,
                                         .overridden = true,
                                         .defaults = &shown.derived,
                                         .target = target.c_str()};
        widgets::Matrix(shown.letter, **by_hand, style);
    } else {
        const widgets::MatrixStyle style{.cells = shown.cells, .roles = shown.roles, .target = target.c_str()};
        const glm::dmat4& value = shown.now;
        widgets::Matrix(shown.letter, value, style);
    }
    ImGui::Dummy({0.0F, px(1.0F)});
    ImGui::PopID();
    return pressed;
}

/// S or R with a button to enter it by hand, or to go back.
void show_overridable(const Shown& shown, const std::string& note, std::optional<glm::dmat4>& by_hand) {
    const char* const buttons[] = {by_hand ? marked("Release") : marked("Edit")};
    if (!show(shown, note, buttons, &by_hand)) return;
    if (by_hand)
        by_hand.reset();
    else
        by_hand = shown.now;
}

/// A line of what is followed, under its name for a lesson.
void followed_line(const char* target, const std::string& text, Role role) {
    if (widgets::IsCovered(target))
        widgets::Plate("value", {ImGui::GetContentRegionAvail().x, widgets::CurrentContext().fonts.number->FontSize});
    else
        widgets::ValueText(text.c_str(), role);
    widgets::MarkTarget(target);
}

/// "name = (   1.000,   2.000,   3.000 )" with the columns of all lines under each other; `w` is a fourth.
void vector_line(const char* target, const char* name, const glm::dvec3& value, Role role, const double* w = nullptr) {
    constexpr std::size_t columns = 7;
    const auto padded = [](double number) {
        const std::string text = number_text(number, 3);
        const std::size_t shown = character_count(text);
        return std::string(shown < columns ? columns - shown : 0, ' ') + text;
    };
    std::string text = std::string(name) + " = (" + padded(value.x) + "," + padded(value.y) + "," + padded(value.z);
    text += w ? "," + padded(*w) + " )" : " )";
    followed_line(target, text, role);
}

void followed_point(Session& session, const Derived& derived) {
    const bool has_several = derived.planes.size() > 1 || derived.lights_world.size() > 1;
    const std::string of = session.params.follow ? session.params.follow->object : "";
    const bool says_which = has_several && derived.followed;
    const std::string note = says_which
                                 ? say("{object} · by plane {plane}, light {light}", "object"_a = of,
                                       "plane"_a = derived.chosen.plane + 1, "light"_a = derived.chosen.light + 1)
                                 : of;
    const bool has_note = heading(marked("Follow a point"), "p", note, Role::point, place_at_right("Clear"));
    // As high without a point: what is below stays where it is when one is clicked.
    const float top = ImGui::GetCursorPosY();
    const float bottom =
        top + 6.0F * (widgets::CurrentContext().fonts.number->FontSize + ImGui::GetStyle().ItemSpacing.y);
    if (!derived.followed) {
        widgets::Note(
            "Click a vertex of an object in the camera view: p, its shadow S p and its mirror image R p are followed "
            "from here.");
        ImGui::SetCursorPosY(bottom - ImGui::GetStyle().ItemSpacing.y);
        ImGui::Dummy({0.0F, 0.0F});
        return;
    }
    ImGui::SameLine(place_at_right("Clear"));
    if (widgets::SmallButton("Clear")) session.params.follow.reset();
    if (!has_note) widgets::Note(note.c_str());
    const FollowedPoint& followed = *derived.followed;
    vector_line("follow:p", "p   ", followed.point_world, Role::point);
    vector_line("follow:S p", "S p ", glm::dvec3(followed.shadow_homogeneous), Role::none,
                &followed.shadow_homogeneous.w);
    if (followed.shadow_world)
        vector_line("follow:shadow", "÷ w ", *followed.shadow_world, Role::light);
    else
        followed_line("follow:shadow", tr("÷ w  at infinity: w = 0"), Role::trouble);
    vector_line("follow:mirrored", "R p ", followed.mirrored_world, Role::mirror);
    vector_line("follow:foot", tr("foot"), followed.foot_world, Role::plane);
    const std::string distance = "k    = n·p + d = " + number_text(followed.plane_distance, 3);
    followed_line("follow:distance", distance, Role::plane);
}

/// Camera movement read both ways: V and C take turns, and below P stands the slide's display().
void camera_matrices(const Params& params, const Derived& derived, const Derived& before, bool& shows_camera_matrix) {
    const SlipParams& slips = params.slips;
    const std::string inverse = identity_text("V C = I", derived.facts.view_residual);
    static constexpr const char* show_view[] = {marked("Show V")};
    static constexpr const char* show_camera[] = {marked("Show C")};
    const char* const product = slips.swapped_order ? tr("C = R_y R_x R_z T, a slip") : "C = T R_y R_x R_z";
    const bool switched =
        shows_camera_matrix
            ? show({marked("Camera"), "C", "world_from_view",
                    marked("Where the camera is: its columns are right, up, back and the eye."), Role::camera,
                    derived.world_from_view, before.world_from_view, camera_cells(slips.swapped_order), camera_roles()},
                   product, show_view)
            : show({marked("View"), "V", "view_from_world",
                    marked("V = C⁻¹: the world as the camera sees it. Its rows are right, up and back."), Role::camera,
                    derived.view_from_world, before.view_from_world,
                    slips.camera_as_view ? camera_cells(slips.swapped_order) : view_cells(slips.swapped_order),
                    camera_roles()},
                   slips.camera_as_view ? tr("= C, a slip") : "= C⁻¹ · " + inverse, show_camera);
    if (switched) shows_camera_matrix = !shows_camera_matrix;

    const bool perspective = params.projection.type == ProjectionType::perspective;
    const auto divided_z = [&](double distance) {
        const glm::dvec4 clip = derived.clip_from_view * glm::dvec4(0.0, 0.0, -distance, 1.0);
        return figures(clip.z / clip.w);
    };
    const std::string becomes =
        say("P takes view space to clip space; after ÷ w near becomes {near} and far {far}.",
            "near"_a = divided_z(params.projection.near), "far"_a = divided_z(params.projection.far));
    const std::string aspect = number_text(derived.aspect, 3);
    show({marked("Projection"), "P", "clip_from_view", becomes.c_str(), Role::camera, derived.clip_from_view,
          before.clip_from_view, projection_cells(params, derived.clip_zero_to_one), camera_roles()},
         !perspective               ? say("aspect {aspect}", "aspect"_a = aspect)
         : slips.degrees_as_radians ? say("c = cot(½ · {fovy} radians), a slip · aspect {aspect}",
                                          "fovy"_a = number_text(params.projection.fovy, 1), "aspect"_a = aspect)
                                    : say("c = cot(½ fovy) · aspect {aspect}", "aspect"_a = aspect),
         {});
    const char* const slide = tr("the slide's display()");
    if (!heading(marked("Camera movement"), "", slide, Role::camera, ImGui::GetContentRegionMax().x))
        widgets::Note(slide);
    if (!widgets::IsPartCovered("code:display"))
        widgets::Tooltip(
            "Moving the camera is moving the world the other way",
            "The lecture's display(), with radians and with pitch and roll: the product is V, so the picture is "
            "the same.");
    draw_display_code(params, derived);
}

/// How far points of the plane are moved: "points of the plane stay ± 0", "points of the plane move by 0.25".
std::string moved_text(const glm::dmat4& matrix, const PlanePatch& patch) {
    double moved = 0.0;
    for (const glm::dvec3& corner : patch.corners()) {
        const glm::dvec4 sent = matrix * glm::dvec4(corner, 1.0);
        if (std::abs(sent.w) < 1e-12) return tr("points of the plane go to infinity");
        moved = std::max(moved, glm::length(glm::dvec3(sent) / sent.w - corner));
    }
    if (moved > 1e-3) return say("points of the plane move by up to {distance}", "distance"_a = number_text(moved, 3));
    return identity_text(tr("points of the plane stay"), moved);
}

/// "plane 1", "plane 2", …: `number` counts from 1 on.
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
    ImGui::TextUnformatted(tr("S and R of"));
    choose_one(marked("plane"), params.view.plane, params.planes.size());
    choose_one(marked("light"), params.view.light, params.lights.size());
}

constexpr const char* shadow_facts[] = {"fact:det_shadow", "fact:rank_shadow", "fact:plane_dot_light"};
constexpr const char* mirror_facts[] = {"fact:det_mirror"};

/// What holds for S; its determinant and Π·L, which stand in it anyway, where a lesson points them out.
std::string shadow_note(const glm::dmat4& shadow, const CastShadow& cast) {
    const std::string identity = identity_text("S² = (Π·L)S", shadow_residual(shadow, cast.plane_dot_light));
    if (widgets::IsHighlighted("fact:det_shadow")) return "det S = " + number_text(glm::determinant(shadow), 3);
    if (widgets::IsHighlighted("fact:plane_dot_light")) return "Π·L = " + number_text(cast.plane_dot_light, 3);
    return say("rank {rank} · {identity}", "rank"_a = rank_of(shadow), "identity"_a = identity);
}

const char* told_sign(const CastShadow& cast) {
    if (widgets::IsCovered("fact:plane_dot_light")) return "S";
    return cast.sign < 0.0 ? "−1·S" : "+1·S";
}

void shadow_and_mirror(Session& session, const Derived& derived, const Derived& before) {
    const DerivedPlane& plane = derived.chosen_plane();
    const CastShadow& cast = derived.chosen_shadow();
    const auto [plane_index, light_index] = derived.chosen;
    PlaneOverrides& overrides = session.params.overrides[plane_index];
    // Another one that is chosen is no change of its entries.
    const bool was_there = plane_index < before.planes.size() && light_index < before.lights_world.size();
    const DerivedPlane& plane_before = was_there ? before.planes[plane_index] : plane;
    const CastShadow& cast_before = was_there ? plane_before.shadows[light_index] : cast;

    const glm::dmat4& shadow = cast.shadowed_world_from_world;
    show_overridable(
        {marked("Shadow"), "S", "shadow_from_world",
         marked("S = (Π·L) I − L Πᵀ with the plane Π scaled to a unit normal: it flattens every point along the "
                "ray from the light, so its determinant is 0. What is uploaded is sign(Π·L) · S, the factor in front: "
                "the same map, but with w > 0, which the clipper keeps."),
         Role::light, shadow, cast_before.shadowed_world_from_world, shadow_cells(), shadow_roles(),
         shadow_matrix(plane.unit_plane, cast.light_world), told_sign(cast), moved_text(shadow, plane.patch),
         shadow_facts},
        shadow_note(shadow, cast), overrides.shadowed_world_from_world[light_index]);

    const glm::dmat4& mirror = plane.mirrored_world_from_world;
    const bool by_rows = session.params.reflection.printed_by_rows;
    const bool is_transposed = by_rows && !overrides.mirrored_world_from_world;
    const std::string determinant = "det " + number_text(glm::determinant(mirror), plane.mirror_has_slip ? 2 : 0);
    const std::string fact = is_transposed           ? tr("as printed")
                             : plane.mirror_has_slip ? say("a slip, {fact}", "fact"_a = determinant)
                                                     : determinant;
    show_overridable(
        {marked("Reflection"), "R", "mirror_from_world",
         marked("R p = p − 2 (n·p + d) n: every point to its mirror image. R is its own inverse and turns the "
                "winding around."),
         Role::mirror, mirror, plane_before.mirrored_world_from_world,
         mirror_cells(by_rows, session.params.slips.plus_2ab), mirror_roles(), mirror_matrix(plane.unit_plane),
         is_transposed ? "Rᵀ" : "R", moved_text(mirror, plane.patch), mirror_facts},
        fact + " · " + identity_text("R² = I", mirror_residual(mirror)), overrides.mirrored_world_from_world);
}

}  // namespace

void draw_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice) {
    const widgets::Group group("matrices");
    choose_pair(session.params);
    const float room = ImGui::GetContentRegionAvail().x, least_column = px(340.0F);
    const bool side_by_side = room >= 2.0F * least_column;
    const auto column = [&](const char* name, const auto& draw) {
        if (side_by_side) ImGui::BeginChild(name, {0.5F * (room - px(16.0F)), 0.0F});
        draw();
        if (side_by_side) ImGui::EndChild();
    };
    column("object space", [&] { shadow_and_mirror(session, derived, before); });
    if (side_by_side) ImGui::SameLine(0.0F, px(16.0F));
    column("view space", [&] {
        followed_point(session, derived);
        ImGui::Dummy({0.0F, px(4.0F)});
        camera_matrices(session.params, derived, before, choice.shows_camera);
    });
}

}  // namespace viewing
