#include "frame/plan/draw_calls.h"

#include <algorithm>

namespace viewing {
namespace {

constexpr int square_triangles = 2;

bool is_square(const Pass& pass) {
    return pass.subject == Subject::patch || pass.subject == Subject::backdrop;
}

int triangles_of(const SceneObject& object) {
    return static_cast<int>(object.mesh->triangle_count());
}

bool is_drawn_as_it_comes(const Pass& pass) {
    return pass.subject != Subject::ordered && pass.subject != Subject::pixels;
}

/// Replaces "no triangle of a call" with "all triangles of the previous call".
DrawLimit without_empty_call(DrawLimit limit, const std::vector<DrawCall>& calls) {
    while (limit.triangles == 0 && limit.call > 0) limit.triangles = calls[--limit.call].triangles;
    return limit;
}

}  // namespace

std::string plane_name(std::size_t plane) {
    return plane == 0 ? marked("plane") : "plane " + std::to_string(plane + 1);
}

bool is_chosen(Chosen chosen, const SceneObject& object) {
    return chosen == Chosen::all || object.description.decal == (chosen == Chosen::decals);
}

int triangles_drawn(const DrawLimit& limit, int call, int triangles) {
    if (limit.call < 0 || call < limit.call) return triangles;
    if (call > limit.call) return 0;
    return limit.triangles < 0 ? triangles : std::min(limit.triangles, triangles);
}

int call_count(const Pass& pass, const Scene& scene) {
    if (is_square(pass)) return 1;
    if (pass.subject != Subject::objects) return 0;
    return static_cast<int>(std::count_if(scene.objects.begin(), scene.objects.end(),
                                          [&](const SceneObject& object) { return is_chosen(pass.chosen, object); }));
}

std::vector<DrawCall> draw_calls(const FramePlan& plan, const Scene& scene) {
    if (!std::all_of(plan.passes.begin(), plan.passes.end(), is_drawn_as_it_comes)) return {};
    std::vector<DrawCall> calls;
    for (std::size_t number = 0; number < plan.passes.size(); ++number) {
        const Pass& pass = plan.passes[number];
        if (is_square(pass)) calls.push_back({number, -1, square_triangles});
        if (pass.subject != Subject::objects) continue;
        for (std::size_t index = 0; index < scene.objects.size(); ++index)
            if (is_chosen(pass.chosen, scene.objects[index]))
                calls.push_back({number, static_cast<int>(index), triangles_of(scene.objects[index])});
    }
    return calls;
}

Message name_of(const DrawCall& call, const FramePlan& plan, const Scene& scene) {
    const Pass& pass = plan.passes.at(call.pass);
    const Message object =
        call.object >= 0 ? object_message(scene.objects.at(static_cast<std::size_t>(call.object)).description.name)
        : pass.subject == Subject::backdrop ? message("square")
                                            : object_message(plane_name(pass.plane));
    return message("{object}, pass {number}: {pass}", "object"_a = object, "number"_a = call.pass + 1,
                   "pass"_a = pass.name);
}

DrawLimit step_before(const DrawLimit& limit, const std::vector<DrawCall>& calls) {
    if (calls.empty()) return {0, 0};
    const int last = static_cast<int>(calls.size()) - 1;
    DrawLimit step{limit.call < 0 ? last : std::min(limit.call, last), 0};
    step.triangles = triangles_drawn(limit, step.call, calls[step.call].triangles);
    step = without_empty_call(step, calls);
    step.triangles = std::max(step.triangles - 1, 0);
    return without_empty_call(step, calls);
}

}  // namespace viewing
