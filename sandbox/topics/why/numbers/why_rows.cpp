// All rows of an explanation except those about lights: the ray, the passes, the mirrors, depth fighting, the samples
// and the sum. Part of why.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "frame/plan/draw_calls.h"
#include "frame/say.h"
#include "topics/depth/numbers/fragment_text.h"
#include "topics/why/numbers/why.h"

namespace viewing {
namespace {

/// Returns "R₂ R₁" for the mirrors on the way.
std::string mirror_product(const WhyQuestion& question, const Pass& pass) {
    if (question.derived.planes.size() == 1) return "R";
    std::string product;
    for (const std::size_t mirror : pass.mirrors_met)
        product += (product.empty() ? "R" : " R") + lowered_text({mirror + 1});
    return product;
}

DepthPrecision precision(const WhyQuestion& question) {
    return precision_of(question.plan.depth_format);
}

/// Returns the matrix that maps the scene to its image behind these mirrors: the product of their R as uploaded.
glm::dmat4 image_from_scene(const Derived& derived, const std::vector<std::size_t>& mirrors_met) {
    glm::dmat4 made(1.0);
    for (const std::size_t mirror : mirrors_met) made = made * derived.planes[mirror].mirrored_world_from_world;
    return made;
}

/// Returns "box (front)".
Message with_side(const Message& name, bool is_front) {
    return listed({name, " (", is_front ? message("front") : message("back"), ")"}, "");
}

/// Says what a fragment does in its pass: the tests with their numbers, and what it writes. `below`: the previous
/// fragment that the same method painted there; null if there is none.
Message outcome(const WhyQuestion& question, const Touch& touch, const Touch* below) {
    const Fragment& fragment = touch.fragment;
    const Pass& pass = question.plan.passes[fragment.pass];
    Message name = surface_name(question, fragment.object_index);
    if (fragment.object_index >= 0 && role_of(pass) == PassRole::objects) name = with_side(name, fragment.front_facing);
    if (pass.subject == Subject::ordered)
        name = message("{surface}, triangle {number} of {count} in the method's order", "surface"_a = name,
                       "number"_a = fragment.triangle + 1,
                       "count"_a = question.plan.drawing_of(pass)->triangles.size() / 3);
    if (fragment.cut_off) return message("{surface} is cut off by a clip plane", "surface"_a = name);
    if (!fragment.is_sent) return message("the method found another surface in front of {surface}", "surface"_a = name);
    if (fragment.culled)
        return fragment.front_facing ? message("{surface} is culled: it shows its front face", "surface"_a = name)
                                     : message("{surface} is culled: it shows its back face", "surface"_a = name);
    if (fragment.stencil_fails)
        return message("{surface}: the stencil value {value} does not match {reference}, so nothing is drawn",
                       "surface"_a = name, "value"_a = fragment.stencil_before,
                       "reference"_a = pass.marks_objects && fragment.object_index >= 0
                                           ? question.plan.mark_of(static_cast<std::size_t>(fragment.object_index))
                                           : pass.stencil.reference);
    std::vector<Message> said{
        message("{surface}: {test}", "surface"_a = name, "test"_a = test_phrase(question, fragment))};
    if (fragment.passes && fragment.stencil_after != fragment.stencil_before)
        said.push_back(message("stencil {before} → {after}", "before"_a = fragment.stencil_before,
                               "after"_a = fragment.stencil_after));
    if (touch.paints && below)
        said.push_back(message("over triangle {number}, {surface}", "number"_a = below->fragment.triangle + 1,
                               "surface"_a = surface_name(question, below->fragment.object_index)));
    if (touch.paints && pass.blend == Blend::alpha)
        said.push_back(message("covers {share} of the color", "share"_a = percent(touch.color.alpha, 0)));
    return listed(said);
}

/// Lists the fragments of one pass. After the first four, fragments that change nothing are only counted.
Message outcomes(const WhyQuestion& question, const std::vector<const Touch*>& touches) {
    constexpr std::size_t most = 4;
    std::vector<Message> said;
    std::size_t left = 0;
    const Touch* below = nullptr;
    for (const Touch* touch : touches) {
        const bool changes = touch->fragment.passes;
        Message text = outcome(question, *touch, below);
        if (touch->paints && question.plan.passes[touch->fragment.pass].subject == Subject::ordered) below = touch;
        if (std::find(said.begin(), said.end(), text) != said.end()) continue;
        if (said.size() < most || changes)
            said.push_back(std::move(text));
        else
            ++left;
    }
    if (left > 0)
        said.push_back(
            message_count(static_cast<std::int64_t>(left), "one more changes nothing", "{count} more change nothing"));
    return listed({listed(said, "; "), "."}, "");
}

struct PathPoint {
    glm::dvec3 world;
    std::size_t mirror;
};

/// Returns where the line of sight to an image meets each mirror on its way.
std::vector<PathPoint> path_of(const Derived& derived, const std::vector<std::size_t>& mirrors_met,
                               const glm::dvec3& eye, const glm::dvec3& point_scene) {
    std::vector<PathPoint> path;
    glm::dvec3 from = eye;
    for (std::size_t i = 0; i < mirrors_met.size(); ++i) {
        const std::vector<std::size_t> rest(mirrors_met.begin() + static_cast<std::ptrdiff_t>(i), mirrors_met.end());
        const glm::dvec4 image = image_from_scene(derived, rest) * glm::dvec4(point_scene, 1.0);
        const glm::dvec3 to = image.w != 0.0 ? glm::dvec3(image) / image.w : glm::dvec3(image);
        const glm::dvec4& plane = derived.planes[mirrors_met[i]].unit_plane;
        const double a = glm::dot(plane, glm::dvec4(from, 1.0)), b = glm::dot(plane, glm::dvec4(to, 1.0));
        if (a == b) break;
        const double t = a / (a - b);
        if (t < 0.0 || t > 1.0) break;
        from = from + t * (to - from);
        path.push_back({from, mirrors_met[i]});
    }
    return path;
}

/// Returns the camera's position; for parallel view rays, a point far along the ray.
glm::dvec3 eye_for(const Derived& derived, const glm::dvec3& point) {
    const glm::dvec4& eye = derived.eye_world;
    return eye.w != 0.0 ? glm::dvec3(eye) / eye.w : point + 100.0 * glm::dvec3(eye);
}

}  // namespace

Message surface_name(const WhyQuestion& question, int object_index) {
    if (object_index == no_object) return message("the whole picture");
    if (object_index < 0)
        return planes_name(std::array{static_cast<std::size_t>(-1 - object_index)}, question.derived.planes.size());
    return object_message(question.finder.scene().objects[object_index].description.name);
}

Message test_phrase(const WhyQuestion& question, const Fragment& fragment) {
    return test_text(fragment, precision(question)).whole(", ");
}

std::string point_text(const glm::dvec3& point) {
    return "(" + number_text(point.x, 2) + ", " + number_text(point.y, 2) + ", " + number_text(point.z, 2) + ")";
}

void add_ray_row(Why& made, const WhyQuestion& question) {
    std::vector<const Fragment*> met;
    std::set<std::pair<int, int>> known;
    for (const Touch& touch : made.chain.touches) {
        const Fragment& one = touch.fragment;
        const Pass& pass = question.plan.passes[one.pass];
        if (pass.is_mirror_image || !is_surface(pass) || !known.insert({one.object_index, one.triangle}).second)
            continue;
        met.push_back(&one);
    }
    std::stable_sort(met.begin(), met.end(), [](const auto* a, const auto* b) { return a->eye_z > b->eye_z; });
    std::vector<Message> said;
    constexpr std::size_t most = 5;
    for (std::size_t i = 0; i < std::min(met.size(), most); ++i) {
        const Fragment& one = *met[i];
        const Message name = surface_name(question, one.object_index);
        const std::string z = number_text(-one.eye_z, 2);
        said.push_back(one.object_index < 0 ? message("{surface} at z = {z}", "surface"_a = name, "z"_a = z)
                       : one.front_facing   ? message("{surface} (front) at z = {z}", "surface"_a = name, "z"_a = z)
                                            : message("{surface} (back) at z = {z}", "surface"_a = name, "z"_a = z));
    }
    if (met.size() > most)
        said.push_back(
            message_count(static_cast<std::int64_t>(met.size() - most), "one more surface", "{count} more surfaces"));
    made.rows.push_back(
        {.kind = WhyRow::Kind::ray,
         .title = message("Ray"),
         .sentences = {met.empty() ? message("The ray meets no surface.")
                       : met.size() == 1
                           ? message("The ray meets {surface}.", "surface"_a = listed(said))
                           : message("The ray meets, from near to far: {surfaces}.", "surfaces"_a = enumerated(said))},
         .is_quiet = met.empty()});
    if (met.empty()) return;
    made.lines.push_back({.kind = WhyLine::Kind::sight,
                          .from_world = eye_for(question.derived, met.front()->point_scene),
                          .to_world = met.front()->point_scene,
                          .row = made.rows.size() - 1});
}

void add_pass_rows(Why& made, const WhyQuestion& question) {
    const FramePlan& plan = question.plan;
    int kept_out = 0;
    for (std::size_t number = 0; number < plan.passes.size(); ++number) {
        std::vector<const Touch*> touches;
        for (const Touch& touch : made.chain.touches)
            if (touch.fragment.pass == number) touches.push_back(&touch);
        if (touches.empty()) continue;
        const Pass& pass = plan.passes[number];
        if (std::all_of(touches.begin(), touches.end(),
                        [](const Touch* touch) { return touch->fragment.stencil_fails; })) {
            ++kept_out;
            continue;
        }
        const bool changes =
            std::any_of(touches.begin(), touches.end(), [](const Touch* touch) { return touch->fragment.passes; });
        const bool paints =
            std::any_of(touches.begin(), touches.end(), [](const Touch* touch) { return touch->paints; });
        made.rows.push_back({.kind = WhyRow::Kind::pass,
                             .title = message("Pass {number}, {pass}", "number"_a = number + 1, "pass"_a = pass.name),
                             .sentences = {outcomes(question, touches)},
                             .after = paints ? std::optional(touches.back()->after) : std::nullopt,
                             .pass = static_cast<int>(number),
                             .is_quiet = !changes});
    }
    if (kept_out > 0)
        made.rows.push_back(
            {.kind = WhyRow::Kind::pass,
             .title = message("Stencil"),
             .sentences = {message_count(kept_out, "One more pass covers this pixel, but the stencil keeps it out.",
                                         "{count} more passes cover this pixel, but the stencil keeps them out.")},
             .is_quiet = true});
}

namespace {

/// Returns the pixel where an image should be if that is not the explained pixel, because the picture in the mirror is
/// drawn with a different lens.
std::optional<glm::ivec2> pixel_elsewhere(const WhyQuestion& question, const glm::dvec3& image_world) {
    const glm::dvec4 clip = question.derived.clip_from_world * glm::dvec4(image_world, 1.0);
    if (!(clip.w > 0.0)) return std::nullopt;
    const glm::dvec2 place =
        (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(question.viewport.size_px);
    const glm::dvec2 off = place - (glm::dvec2(question.pixel) + 0.5);
    constexpr double far_px = 1e6;  // larger coordinates are not pixels
    if (glm::length(off) <= 1.5 || !(glm::length(off) < far_px)) return std::nullopt;
    return glm::ivec2(glm::floor(place));
}

void add_mirror_row(Why& made, const WhyQuestion& question, const Touch* image) {
    const Pass& pass = question.plan.passes[image->fragment.pass];
    const glm::dvec3& q = image->fragment.point_scene;
    const glm::dvec4 seen = image_from_scene(question.derived, pass.mirrors_met) * glm::dvec4(q, 1.0);
    const glm::dvec3 image_world = seen.w != 0.0 ? glm::dvec3(seen) / seen.w : glm::dvec3(seen);
    const glm::dvec3 eye = eye_for(question.derived, image_world);
    const std::vector<PathPoint> path = path_of(question.derived, pass.mirrors_met, eye, q);
    std::vector<Message> way;
    for (const PathPoint& point : path) {
        way.push_back(message("{plane} at {point}",
                              "plane"_a = planes_name(std::array{point.mirror}, question.derived.planes.size()),
                              "point"_a = point_text(point.world)));
        way.push_back(" → ");
    }
    const Message object = surface_name(question, image->fragment.object_index);
    const std::string product = mirror_product(question, pass);
    const std::optional<glm::ivec2> elsewhere = pixel_elsewhere(question, image_world);
    const Message sentence =
        elsewhere
            ? message(
                  "Drawn here: {object} at q = {q}. Its image {product} q = {image} belongs at pixel ({x}, {y}): the "
                  "picture in the mirror uses a different lens than the camera.",
                  "object"_a = object, "q"_a = point_text(q), "product"_a = product,
                  "image"_a = point_text(image_world), "x"_a = elsewhere->x, "y"_a = elsewhere->y)
            : message("The line of sight goes to {way}{object} at q = {q}; {product} q = {image}.",
                      "way"_a = listed(way, ""), "object"_a = object, "q"_a = point_text(q), "product"_a = product,
                      "image"_a = point_text(image_world));
    made.rows.push_back(
        {.kind = WhyRow::Kind::mirror, .title = message("Mirror"), .sentences = {sentence}, .after = image->after});
    const std::size_t row = made.rows.size() - 1;
    glm::dvec3 from = eye;
    for (const PathPoint& point : path) {
        made.lines.push_back({WhyLine::Kind::sight, from, point.world, {}, row});
        from = point.world;
    }
    made.lines.push_back({WhyLine::Kind::sight, from, q, object, row});
    if (!path.empty())
        made.lines.push_back({WhyLine::Kind::image, path.front().world, image_world,
                              message("image of {object}", "object"_a = object), row});
}

}  // namespace

void add_mirror_rows(Why& made, const WhyQuestion& question) {
    for (const Touch* image : images_of(made, question.plan)) add_mirror_row(made, question, image);
}

void add_fight_row(Why& made, const WhyQuestion& question) {
    const Touch* surface = made.chain.surface(question.plan);
    if (!surface) return;
    const auto is_of_frame = [&](const Touch& touch) {
        const Pass& pass = question.plan.passes[touch.fragment.pass];
        return !pass.is_mirror_image && role_of(pass) != PassRole::mask && role_of(pass) != PassRole::backdrop;
    };
    // The last fragment that is compared with another at nearly the same depth; one of the two must be the visible one.
    const Touch* rival = nullptr;
    const Touch* other = nullptr;
    const Touch* writer = nullptr;
    for (const Touch& touch : made.chain.touches) {
        if (!is_of_frame(touch)) continue;
        if (writer && is_decided_by_rounding(touch.fragment) && (&touch == surface || writer == surface)) {
            rival = &touch;
            other = writer;
        }
        const DepthState& depth = touch.fragment.depth;
        if (touch.fragment.passes && depth.test && depth.write) writer = &touch;
    }
    if (!rival) return;
    const Fragment& one = rival->fragment;
    const bool is_same_object = one.object_index == other->fragment.object_index;
    const auto fighter_name = [&](const Fragment& fragment) {
        const Message name = surface_name(question, fragment.object_index);
        if (role_of(question.plan.passes[fragment.pass]) == PassRole::shadow)
            return message("the shadow of {caster}", "caster"_a = name);
        return is_same_object ? with_side(name, fragment.front_facing) : name;
    };
    const Message name = fighter_name(one), rival_name = fighter_name(other->fragment);
    const auto apart = std::abs(static_cast<std::int64_t>(one.stored) - static_cast<std::int64_t>(one.compared_with));
    std::vector<Message> said{
        apart == 0
            ? message("{surface} and {other} store the same code {code}: the depth test cannot tell them apart.",
                      "surface"_a = name, "other"_a = rival_name, "code"_a = code_text(one.stored, precision(question)))
            : message_count(
                  apart, "{surface} and {other} store {code} and {stored}, one code apart: within GL's rounding error.",
                  "{surface} and {other} store {code} and {stored}, {count} codes apart: within GL's rounding error.",
                  "surface"_a = name, "other"_a = rival_name, "code"_a = code_text(one.stored, precision(question)),
                  "stored"_a = code_text(one.compared_with, precision(question)))};
    const std::vector<SceneObject>& objects = question.finder.scene().objects;
    for (const int index : std::set{one.object_index, other->fragment.object_index})
        if (index >= 0 && question.plan.decal_offset != DepthOffset{} && objects[index].description.decal)
            said.push_back(
                message("The polygon offset of {object} is included.", "object"_a = surface_name(question, index)));
    const glm::ivec2 beside =
        question.pixel + glm::ivec2(question.pixel.x + 1 < question.viewport.size_px.x ? 1 : -1, 0);
    const PixelChain there = pixel_chain(question.plan, question.finder, beside, question.viewport.size_px);
    const Touch* seen = there.surface(question.plan);
    if (seen)
        said.push_back(message("With depth computed exactly and then rounded, the pixel beside it shows {surface}.",
                               "surface"_a = surface_name(question, seen->fragment.object_index)));
    made.rows.push_back(
        {.kind = WhyRow::Kind::fight, .title = message("Depth fighting"), .sentences = {listed(said, " ")}});
}

void add_sample_row(Why& made, const WhyQuestion& question) {
    if (question.plan.samples == 0) return;
    // In GL's usual pattern, a pixel's four samples lie at pixel centers of a picture four times as wide and four times
    // as high. `places` lists these pixels, counted from the top left of the large pixel.
    static constexpr glm::ivec2 places[] = {{1, 0}, {3, 1}, {0, 2}, {2, 3}};
    std::vector<std::pair<Message, int>> seen;
    for (const glm::ivec2& place : places) {
        const PixelChain chain =
            pixel_chain(question.plan, question.finder, 4 * question.pixel + place, 4 * question.viewport.size_px);
        const Touch* surface = chain.surface(question.plan);
        const Message name =
            surface ? surface_name(question, surface->fragment.object_index) : message("the background");
        const auto known = std::find_if(seen.begin(), seen.end(), [&](const auto& one) { return one.first == name; });
        if (known == seen.end())
            seen.emplace_back(name, 1);
        else
            ++known->second;
    }
    if (seen.size() == 1) return;
    std::vector<Message> parts;
    for (const auto& [name, count] : seen)
        parts.push_back(message("{surface}: {count} of 4", "surface"_a = name, "count"_a = count));
    made.rows.push_back({.kind = WhyRow::Kind::samples,
                         .title = message("Samples"),
                         .sentences = {message("With multisampling, several surfaces share this pixel: {surfaces}.",
                                               "surfaces"_a = enumerated(parts))}});
}

namespace {

/// Compares the explained color with the one in the buffer.
Message read_back_text(const Why& made, const Color& read_back) {
    const Color& color = *made.predicted;
    if (!is_same_color(color, read_back)) return message("but {color} is read back", "color"_a = hex_of(read_back));
    if (made.chain.is_as_rounded()) return message("as read back; two depths are so close that rounding decides");
    if (hex_of(color) == hex_of(read_back)) return message("as read back");
    return message("read back as {color}: rounding to 8 bits", "color"_a = hex_of(read_back));
}

}  // namespace

void add_sum_row(Why& made, const WhyQuestion& question) {
    if (!made.predicted) return;
    std::string sum;
    const auto add = [&](double share, const glm::dvec3& srgb) {
        if (share < least_share) return;
        const glm::ivec3 level = glm::ivec3(glm::round(255.0 * srgb));
        const std::string color = hex_color(static_cast<std::uint8_t>(level.r), static_cast<std::uint8_t>(level.g),
                                            static_cast<std::uint8_t>(level.b));
        sum += (sum.empty() ? "" : " + ") + (share > 0.996 ? color : number_text(share, 2) + " · " + color);
    };
    const Color& background = made.chain.background;
    add(made.chain.background_share, glm::dvec3(background.r, background.g, background.b) / 255.0);
    for (const Touch& touch : made.chain.touches) add(touch.share, touch.color.srgb);
    const Color& color = *made.predicted;
    const std::string result = hex_of(color);
    Message said = verbatim(sum == result ? result : sum + " = " + result);
    switch (question.plan.shows) {
        case Shows::stencil:
            said = message("stencil {value} is shown as {color}", "value"_a = made.chain.stencil, "color"_a = result);
            break;
        case Shows::depth:
            said = made.chain.has_depth
                       ? message("depth code {code} is shown as {color}",
                                 "code"_a = code_text(made.chain.stored, precision(question)), "color"_a = result)
                       : message("nothing wrote depth: shown as {color}", "color"_a = result);
            break;
        case Shows::overdraw:
            said = message_count(static_cast<std::int64_t>(made.chain.times_painted()),
                                 "color written once: shown as {color}",
                                 "color written {count} times: shown as {color}", "color"_a = result);
            break;
        case Shows::facing:
            if (const Touch* surface = made.chain.surface(question.plan))
                said = surface->fragment.front_facing ? message("the front face is shown as {color}", "color"_a = said)
                                                      : message("the back face is shown as {color}", "color"_a = said);
            break;
        default:
            break;
    }
    if (question.read_back) said = listed({said, read_back_text(made, *question.read_back)});
    made.rows.push_back({.kind = WhyRow::Kind::sum, .title = "=", .sentences = {said}, .after = color});
}

}  // namespace viewing
