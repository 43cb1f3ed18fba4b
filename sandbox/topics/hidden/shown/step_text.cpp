#include "topics/hidden/shown/step_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/hidden/numbers/step_groups.h"
#include "topics/hidden/shown/polygon_names.h"
#include "widgets/widgets.h"

namespace viewing {
namespace {

int source_of(const HiddenResult& result, int fragment) {
    if (!result.fragments || fragment < 0 || fragment >= std::ssize(*result.fragments)) return -1;
    return (*result.fragments)[fragment].source;
}

std::string name_at(const HiddenResult& result, int fragment) {
    return polygon_name(result.surface.get(), source_of(result, fragment));
}

std::string pixel_text(glm::ivec2 pixel) {
    return say("pixel ({x}, {y})", "x"_a = pixel.x, "y"_a = pixel.y);
}

/// Whether a cut's plane is the plane of this fragment, in either orientation.
bool is_plane_of(const HiddenResult& result, int fragment, const glm::dvec4& plane) {
    if (source_of(result, fragment) < 0) return false;
    const glm::dvec4& own = (*result.fragments)[fragment].plane;
    constexpr double rounding = 1e-9;
    return glm::length(own - plane) < rounding || glm::length(own + plane) < rounding;
}

std::string cut_sentence(const HiddenResult& result, const NewellStep& step) {
    const bool cuts_p = step.split == step.p;
    const bool by_plane = is_plane_of(result, cuts_p ? step.q : step.p, step.cut_plane);
    if (by_plane) return cuts_p ? tr("The plane of B cuts A.") : tr("The plane of A cuts B.");
    return cuts_p ? tr("A is cut by a plane through the eye and an edge of B.")
                  : tr("B is cut by a plane through the eye and an edge of A.");
}

/// In the order of NewellAction. A cut has sentences of its own.
constexpr auto action_texts =
    per_enum<NewellAction>(marked("A may go before B."), marked("Swap: B goes before A."), "",
                           marked("A can hide none of the remaining polygons, so A is drawn."),
                           marked("A is drawn despite B: they overlap by less than epsilon."));

std::string action_sentence(const HiddenResult& result, const NewellStep& step) {
    return step.action == NewellAction::splits ? cut_sentence(result, step) : tr(action_texts[step.action]);
}

/// In the order of NewellTest.
constexpr auto test_texts = per_enum<NewellTest>(
    marked("apart in depth"), marked("apart along x"), marked("apart along y"), marked("A behind the plane of B"),
    marked("B in front of the plane of A"), marked("apart on the screen"), marked("B behind the plane of A"),
    marked("A in front of the plane of B"), marked("none: cut"));
static_assert(std::size(test_texts) == newell_test_count);

/// Returns how many decimals, from 4 to 9, are enough to distinguish two depths.
int decimals_for(double a, double b) {
    const double apart = std::abs(a - b);
    if (!std::isfinite(apart) || apart <= 0.0) return 4;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(apart))) + 1, 4, 9);
}

}  // namespace

const char* newell_test_text(NewellTest test) {
    return test_texts[test];
}

const NewellStep* newell_step(const HiddenResult& result) {
    return result.newell && result.step > 0 ? &result.newell->steps[result.step - 1] : nullptr;
}

std::optional<Ladder> newell_ladder(const HiddenResult& result) {
    if (!newell_step(result)) return std::nullopt;
    const NewellStep& step = *newell_step(result);
    Ladder ladder{.p = name_at(result, step.p),
                  .q = step.q >= 0 ? name_at(result, step.q) : "",
                  .action = action_sentence(result, step)};
    const auto decided = static_cast<std::size_t>(step.decided_by);
    for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung)
        ladder.rungs[rung] = step.q < 0        ? RungState::untried
                             : rung < decided  ? RungState::failed
                             : rung == decided ? RungState::decided
                                               : RungState::untried;
    return ladder;
}

std::string compare_sentence(const HiddenResult& result) {
    if (!result.compare || result.compare->polygon < 0) return "";
    const RasterStep& step = *result.compare;
    const int decimals = decimals_for(step.depth, step.stored_depth);
    const std::string depth = number_text(step.depth, decimals);
    const std::string stored = number_text(step.stored_depth, decimals);
    const char* relation = depth == stored ? "=" : step.depth < step.stored_depth ? "<" : ">";
    const std::string pixel = pixel_text({step.x, step.y}), polygon = name_at(result, step.polygon);
    return step.written
               ? say("{pixel}: {polygon}, depth {depth} {relation} stored {stored} → written", "pixel"_a = pixel,
                     "polygon"_a = polygon, "depth"_a = depth, "relation"_a = relation, "stored"_a = stored)
               : say("{pixel}: {polygon}, depth {depth} {relation} stored {stored} → not written", "pixel"_a = pixel,
                     "polygon"_a = polygon, "depth"_a = depth, "relation"_a = relation, "stored"_a = stored);
}

std::string progress_sentence(const HiddenResult& result, int step) {
    const std::optional<StepPlace> place = place_of_step(result, step);
    if (!place)
        return say("polygon {step} of {count}", "step"_a = grouped_number(step < 0 ? result.step_count : step),
                   "count"_a = grouped_number(result.step_count));
    const std::string group = grouped_number(place->group), groups = grouped_number(place->groups);
    const std::string within = grouped_number(place->within), size = grouped_number(place->size);
    return say(fmt::runtime(hidden_method(result.request.visibility.method).words.progress(place->group)),
               "group"_a = group, "groups"_a = groups, "within"_a = within, "size"_a = size, "node"_a = within,
               "count"_a = size);
}

std::vector<std::string> progress_numbers(const HiddenResult& result, int step) {
    const auto of = [](int done, int count) { return grouped_number(done) + "/" + grouped_number(count); };
    const std::optional<StepPlace> place = place_of_step(result, step);
    if (!place) return {of(step < 0 ? result.step_count : step, result.step_count)};
    const std::string groups = of(place->group, place->groups);
    return {groups + " · " + of(place->within, place->size), groups};
}

std::vector<RayHitRow> ray_rows(const HiddenResult& result) {
    std::vector<RayHitRow> rows;
    if (!result.traced) return rows;
    for (const RayCastHit& hit : result.traced->hits) rows.push_back({hit.polygon, hit.source, hit.t});
    return rows;
}

std::string ray_sentence(const HiddenResult& result) {
    if (!result.traced)
        return result.step < 0 ? tr("One ray went through each pixel. To see what a single ray hits, go to one of the "
                                    "steps or, in a small raster, click a pixel.")
                               : tr("No ray has been cast yet.");
    const std::string pixel = pixel_text(result.traced->pixel);
    const auto hits = static_cast<std::int64_t>(result.traced->hits.size());
    if (hits == 0) return say("The ray through {pixel} hits no object.", "pixel"_a = pixel);
    return say_count(hits, "The ray through {pixel} hits one surface, which is visible.",
                     "The ray through {pixel} hits {count} surfaces: the first one is visible.", "pixel"_a = pixel);
}

}  // namespace viewing
