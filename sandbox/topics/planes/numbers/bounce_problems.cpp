// Reports mirrors that show each other, and how many of their reflections are missing. Part of problems.h.
#include <algorithm>
#include <limits>

#include "frame/say.h"
#include "topics/planes/numbers/drawn_mirrors.h"

namespace viewing {
namespace {

/// The most reflections to follow along a view ray; no state requests that many bounces.
constexpr int most_followed = 17;

bool are_endless(const Mirror& one, const Mirror& other) {
    return glm::dot(glm::dvec3(one.towards_eye()), glm::dvec3(other.towards_eye())) < -1.0 + 1e-12;
}

/// Returns how often mirrors reflect a view ray that meets `first` at the point `at`. A mirror reflects only on the
/// eye's side.
int reflections_of(const std::vector<Mirror>& mirrors, const Mirror& first, glm::dvec3 at, glm::dvec3 direction) {
    const Mirror* met = &first;
    int count = 0;
    while (met && ++count < most_followed) {
        const glm::dvec3 normal(met->towards_eye());
        direction -= 2.0 * glm::dot(normal, direction) * normal;
        const Mirror* next = nullptr;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Mirror& mirror : mirrors) {
            const double approach = glm::dot(glm::dvec3(mirror.towards_eye()), direction);
            const double way = -glm::dot(mirror.towards_eye(), glm::dvec4(at, 1.0)) / approach;
            if (&mirror == met || !(approach < 0.0) || !(way > 0.0) || way >= nearest) continue;
            if (!mirror.plane.patch.holds(at + way * direction)) continue;
            nearest = way;
            next = &mirror;
        }
        if (next) at += nearest * direction;
        met = next;
    }
    return count;
}

/// Returns the largest number of reflections among a grid of view rays through each mirror's patch.
int most_reflections(const std::vector<Mirror>& mirrors, const glm::dvec4& eye_world) {
    constexpr int grid = 24;
    int most = 0;
    for (const Mirror& mirror : mirrors)
        for (int cell = 0; cell < grid * grid; ++cell) {
            const glm::dvec2 place = (glm::dvec2(cell % grid, cell / grid) + 0.5) * (2.0 / grid) - 1.0;
            const PlanePatch& patch = mirror.plane.patch;
            const glm::dvec3 at = patch.center + patch.extent * (place.x * patch.u + place.y * patch.v);
            most = std::max(most, reflections_of(mirrors, mirror, at, line_of_sight(eye_world, at)));
        }
    return most;
}

}  // namespace

void find_bounce_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const std::vector<Mirror>& mirrors, int depth) {
    if (mirrors.size() < 2) return;
    Sayer tell(problems, "reflection");
    if (!params.reflection.stencil)
        return tell.broken(
            params.reflection.bounces > 1,
            sentence("reflection.one_bounce", "without the stencil, only the first of {bounces} bounces is drawn",
                     "bounces"_a = params.reflection.bounces),
            "reflection.stencil");
    bool is_endless = false;
    for (std::size_t one = 0; one < mirrors.size(); ++one)
        for (std::size_t other = one + 1; other < mirrors.size(); ++other)
            is_endless = is_endless || are_endless(mirrors[one], mirrors[other]);
    const int most = is_endless ? most_followed : most_reflections(mirrors, derived.eye_world);
    if (!is_endless && most <= depth) return;
    if (depth < params.reflection.bounces)
        return tell(true,
                    sentence("reflection.fewer_bounces",
                             "{depth} of {bounces} bounces are drawn: more would redraw the scene too often or exceed "
                             "the stencil's range",
                             "depth"_a = depth, "bounces"_a = params.reflection.bounces));
    const Message unreflected = depth == 1 ? message("a mirror seen in a mirror")
                                           : message("the mirror after {depth} bounces", "depth"_a = depth);
    if (is_endless) {
        const Sentence endless =
            sentence("reflection.endless",
                     "mirrors facing each other reflect endlessly: {unreflected} is drawn without its image",
                     "unreflected"_a = unreflected);
        return depth == 1 ? tell.broken(true, endless, "reflection.bounces=8") : tell(true, endless);
    }
    tell(true,
         most < most_followed
             ? sentence("reflection.in_a_row",
                        "a line of sight hits up to {count} mirrors in a row: {unreflected} is drawn without its image",
                        "count"_a = most, "unreflected"_a = unreflected)
             : sentence("reflection.in_a_row",
                        "a line of sight hits mirrors again and again: {unreflected} is drawn without its image",
                        "unreflected"_a = unreflected));
}

}  // namespace viewing
