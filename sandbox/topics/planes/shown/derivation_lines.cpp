#include "topics/planes/shown/derivation_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "text/catalogue.h"
#include "topics/planes/shown/derivation_text.h"

namespace viewing {
namespace {

using Lines = std::vector<DerivationLine>;

void add_result(Lines& lines, std::vector<std::string> parts) {
    lines.push_back({DerivationLine::Kind::equation, std::move(parts), "", false});
}
void add_step(Lines& lines, std::vector<std::string> parts) {
    lines.push_back({DerivationLine::Kind::equation, std::move(parts), "", true});
}
void heading(Lines& lines, const char* text, bool is_step = true) {
    lines.push_back({DerivationLine::Kind::heading, {text}, "", is_step});
}
void note(Lines& lines, const char* text) {
    lines.push_back({DerivationLine::Kind::note, {text}, "", true});
}

/// Puts a negative factor in parentheses: "= 5.200·(−1.300)".
std::string in_brackets(double value) {
    std::string number = derivation_number(value);
    return number.starts_with("−") ? "(" + number + ")" : number;
}

std::string equals(double value) {
    return "= " + derivation_number(value);
}

/// Returns "= a/(b − c)" with numbers in place of the letters.
std::string quotient(double over, double from, double minus) {
    return equals(over) + "/(" + derivation_number(from) + " − " + in_brackets(minus) + ")";
}

/// Returns "= a/b" with numbers in place of the letters.
std::string divided(double over, double by) {
    return equals(over) + "/" + in_brackets(by);
}

std::string signed_sum(std::span<const double> terms) {
    std::string text;
    for (std::size_t term = 0; term < terms.size(); ++term) {
        if (term > 0) text += terms[term] < 0.0 ? " − " : " + ";
        text += derivation_number(term > 0 ? std::abs(terms[term]) : terms[term]);
    }
    return text;
}

/// S p before the division: (n·l + d) p − (n·p + d) l, and w.
glm::dvec4 projected(const ShadowDerivation& found) {
    return {found.light_height * found.point_world - found.point_height * found.light_world,
            found.parallel_light ? found.n_dot_l : found.n_dot_l - found.n_dot_p};
}

/// Adds lines that explain why a fourth coordinate is needed.
void introduce_w(Lines& lines) {
    heading(lines, marked("The common denominator becomes w"));
    note(
        lines,
        marked("No matrix can divide by a value that differs from point to point. So the last row puts the denominator "
               "into w, and the division comes last. The slide writes 1 instead, the value of w after the division."));
}

/// Adds the rows of the slide "Planar Shadow", for y = 0.
void blinn_rows(Lines& lines, const ShadowDerivation& found) {
    const glm::dvec3 &l = found.light_world, &p = found.point_world, &s = *found.shadow_world;
    const glm::dvec4 sum = projected(found);
    heading(lines, marked("Similar triangles give the same result"));
    add_step(lines, {"(s_x − l_x)/(p_x − l_x)", "= l_y/(l_y − p_y)", equals(found.t)});
    heading(lines, marked("Coordinate by coordinate"));
    add_step(lines, {"s_x", "= l_x + l_y/(l_y − p_y) (p_x − l_x)"});
    add_step(lines, {"s_x", "= (l_x (l_y − p_y) + l_y (p_x − l_x))/(l_y − p_y)"});
    add_step(lines, {"s_x", "= (l_y p_x − l_x p_y)/(l_y − p_y)", divided(sum.x, sum.w), equals(s.x)});
    add_step(lines, {"s_y", "= 0"});
    add_step(lines, {"s_z", "= (l_y p_z − l_z p_y)/(l_y − p_y)", divided(sum.z, sum.w), equals(s.z)});
    introduce_w(lines);
    add_step(lines, {"S p", "= (l_y p_x − l_x p_y, 0, l_y p_z − l_z p_y)"});
    add_step(lines, {"S p", "= " + derivation_vector(glm::dvec3(sum))});
    add_step(lines, {"w", "= −p_y + l_y", "= " + signed_sum(std::array{-p.y, l.y}), equals(sum.w)});
}

/// Adds the rows of the slide "Projection Shadow", for any plane.
void general_rows(Lines& lines, const ShadowDerivation& found) {
    const glm::dvec4 sum = projected(found);
    heading(lines, marked("Coordinate by coordinate"));
    add_step(lines, {"s_x", "= l_x + (n·l + d)/(n·l − n·p) (p_x − l_x)"});
    add_step(lines, {"s_x", "= (l_x (n·l − n·p) + (n·l + d) (p_x − l_x))/(n·l − n·p)"});
    add_step(lines, {"s_x", "= ((n·l + d − l_x n_x) p_x", "− l_x n_y p_y − l_x n_z p_z − l_x d)/(n·l − n·p)"});
    add_step(lines, {"s_x", divided(sum.x, sum.w), equals(found.shadow_world->x)});
    add_step(lines, {"s_y", divided(sum.y, sum.w), equals(found.shadow_world->y)});
    add_step(lines, {"s_z", divided(sum.z, sum.w), equals(found.shadow_world->z)});
    introduce_w(lines);
    // l is (x, y, z) ÷ l_w, so the matrix has one more factor l_w, which the division by w removes.
    const double l_w = found.light.w;
    const auto times_l_w = [l_w](const std::string& sum_text) {
        return l_w == 1.0 ? "= " + sum_text : "= l_w (" + sum_text + ")";
    };
    add_step(lines, {"S p", times_l_w("(n·l + d) p − (n·p + d) l"), "= " + derivation_vector(l_w * glm::dvec3(sum))});
    add_step(lines, {"w", times_l_w("−n_x p_x − n_y p_y − n_z p_z + n·l"), equals(l_w * sum.w)});
}

void point_light_lines(Lines& lines, const ShadowDerivation& found, bool is_blinn) {
    add_result(lines, {"s", "= l + t (p − l)"});
    add_result(lines, {"n·s + d", "= 0"});
    add_step(lines, {"n·(l + t (p − l)) + d", "= 0"});
    add_step(lines, {"t (n·p − n·l)", "= −d − n·l"});
    if (!found.shadow_world) return;
    add_result(lines, {"t", "= (n·l + d)/(n·l − n·p)", quotient(found.light_height, found.n_dot_l, found.n_dot_p),
                       equals(found.t)});
    if (is_blinn)
        add_result(lines,
                   {"t", "= l_y/(l_y − p_y)", quotient(found.light_world.y, found.light_world.y, found.point_world.y),
                    equals(found.t), marked("for y = 0")});
    add_result(lines, {"s", "= " + derivation_vector(*found.shadow_world)});
    add_result(lines, {"|s − l|", found.t < 0.0 ? "= |t| |p − l|" : "= t |p − l|",
                       "= " + derivation_number(std::abs(found.t)) + "·" + derivation_number(found.light_to_point),
                       equals(found.light_to_shadow)});
    if (is_blinn)
        blinn_rows(lines, found);
    else
        general_rows(lines, found);
}

void parallel_light_lines(Lines& lines, const ShadowDerivation& found) {
    add_result(lines, {"s", "= p + τ l", marked("for l_w = 0")});
    add_result(lines, {"n·s + d", "= 0"});
    add_step(lines, {"n·(p + τ l) + d", "= 0"});
    if (!found.shadow_world) return;
    add_result(lines, {"τ", "= −(n·p + d)/(n·l)",
                       "= −" + in_brackets(found.point_height) + "/" + in_brackets(found.n_dot_l), equals(found.t)});
    add_result(lines, {"s", "= " + derivation_vector(*found.shadow_world)});
    add_result(lines, {"|s − p|", equals(found.point_to_shadow)});
    const glm::dvec4 sum = projected(found);
    heading(lines, marked("The common denominator becomes w"));
    add_step(lines, {"S p", "= (n·l) p − (n·p + d) l", "= " + derivation_vector(glm::dvec3(sum))});
    add_step(lines, {"w", "= n·l", equals(sum.w), marked("for every point")});
}

}  // namespace

std::vector<DerivationLine> shadow_lines(const ShadowDerivation& found, bool is_blinn) {
    Lines lines;
    heading(lines, marked("Step by step"));
    if (found.parallel_light)
        parallel_light_lines(lines, found);
    else
        point_light_lines(lines, found, is_blinn);
    if (found.shadow_world) {
        const glm::dvec4 sum = projected(found);
        add_step(lines, {"s", "= S p ÷ w", "= " + derivation_vector(glm::dvec3(sum) / sum.w)});
    }
    for (DerivationLine& line : lines) line.target = "text:shadow_derivation.lines";
    return lines;
}

std::vector<DerivationLine> mirror_lines(const MirrorDerivation& found) {
    Lines lines;
    const auto named = [&lines](const char* target, std::vector<std::string> parts) {
        add_result(lines, std::move(parts));
        lines.back().target = target;
    };
    named("text:mirror_derivation.k", {"k", "= n·q + d", equals(found.k)});
    named("text:mirror_derivation.foot", {marked("foot"), "= q − k n", "= " + derivation_vector(found.foot_world)});
    named("text:mirror_derivation.mirrored", {"q′", "= q − 2 k n", "= " + derivation_vector(found.mirrored_world)});
    heading(lines, marked("Expanded"), false);
    static constexpr const char* rows[3][5] = {{"x_0′", "= (1 - 2a^2) x_0", "- 2ab y_0", "- 2ac z_0", "- 2ad"},
                                               {"y_0′", "= -2ab x_0", "+ (1 - 2b^2) y_0", "- 2bc z_0", "- 2bd"},
                                               {"z_0′", "= -2ac x_0", "- 2bc y_0", "+ (1 - 2c^2) z_0", "- 2cd"}};
    for (int row = 0; row < 3; ++row) {
        const auto& [name, x, y, z, d] = rows[row];
        named("text:mirror_derivation.rows",
              {name, x, y, z, d, "= " + signed_sum(found.terms[row]), equals(found.mirrored_world[row])});
    }
    lines.push_back({DerivationLine::Kind::note,
                     {marked("The slide's second line begins with 2ab x₀; it should be −2ab x₀.")},
                     "text:mirror_derivation.rows",
                     false});
    return lines;
}

int step_count(const std::vector<DerivationLine>& lines) {
    return static_cast<int>(std::count_if(lines.begin(), lines.end(), [](const DerivationLine& line) {
        return line.kind != DerivationLine::Kind::heading;
    }));
}

std::vector<DerivationLine> lines_until(const std::vector<DerivationLine>& lines, int steps) {
    if (steps < 0 || steps >= step_count(lines)) return lines;
    std::vector<DerivationLine> shown;
    for (const DerivationLine& line : lines) {
        const bool is_heading = line.kind == DerivationLine::Kind::heading;
        if (!is_heading && steps-- == 0) break;
        shown.push_back(line);
    }
    while (!shown.empty() && shown.back().kind == DerivationLine::Kind::heading) shown.pop_back();
    return shown;
}

}  // namespace viewing
