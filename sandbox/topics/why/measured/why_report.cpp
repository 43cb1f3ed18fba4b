#include "topics/why/measured/why_report.h"

#include "report/as_json.h"
#include "text/per_enum.h"
#include "topics/hidden/measured/camera_picture.h"
#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {
namespace {

constexpr auto kind_names =
    per_enum<WhyRow::Kind>("ray", "pass", "mirror", "light", "fight", "fault", "samples", "sum");

Json touch_as_json(const Touch& touch) {
    const Fragment& fragment = touch.fragment;
    Json json = {{"pass", fragment.pass + 1},
                 {"object", fragment.object},
                 {"passes", fragment.passes},
                 {"paints", touch.paints},
                 {"stored", fragment.stored},
                 {"compared_with", fragment.compared_with},
                 {"stencil_before", fragment.stencil_before},
                 {"stencil_after", fragment.stencil_after},
                 {"point", as_json(fragment.point_scene)},
                 {"share", touch.share},
                 {"after", as_text(touch.after)}};
    if (fragment.culled) json["culled"] = true;
    if (fragment.cut_off) json["clipped"] = true;
    if (fragment.stencil_fails) json["stencil_fails"] = true;
    if (fragment.decided_by_rounding) json["rounding"] = true;
    return json;
}

}  // namespace

Result<std::vector<Why>> explained_pixels(Renderer& renderer, const Params& state, const Scene& scene,
                                          std::span<const glm::ivec2> pixels, glm::ivec2 size_px) {
    Params params = state;
    params.view.samples = 0;
    const Result<Image> picture = camera_picture(renderer, params, scene, size_px);
    if (!picture) return Error{picture.error()};
    const Viewport viewport = renderer.viewport(size_px, params.depth.format);
    const Derived derived = derive(params, scene, viewport);
    Result<FramePlan> frame = plan_at_once(renderer, params, derived, scene, size_px);
    if (!frame) return Error{frame.error()};
    const std::vector<Problem> problems = find_problems(params, derived, scene, *frame);
    frame->samples = state.view.samples;  // the explained picture may be multisampled
    const FragmentFinder finder(scene);
    const auto solve = [&](const Params& fixed, const Derived& numbers) {
        const Result<FramePlan> solved = plan_at_once(renderer, fixed, numbers, scene, size_px);
        return solved ? solved->hidden : HiddenPictures{};
    };
    std::vector<Why> made;
    for (const glm::ivec2& pixel : pixels)
        made.push_back(
            why({params, derived, *frame, finder, viewport, problems, pixel, color_at(*picture, pixel), solve}));
    return made;
}

Json why_as_json(const Why& why) {
    Json rows = Json::array(), touches = Json::array();
    for (const WhyRow& row : why.rows) {
        Json json = {
            {"kind", kind_names[row.kind]}, {"title", say(row.title)}, {"say", say(listed(row.sentences, " "))}};
        if (row.after) json[row.kind == WhyRow::Kind::fault ? "with_fix" : "after"] = as_text(*row.after);
        if (row.pass >= 0) json["pass"] = row.pass + 1;
        if (!row.fix.empty()) json["fix"] = row.fix;
        rows.push_back(std::move(json));
    }
    for (const Touch& touch : why.chain.touches) touches.push_back(touch_as_json(touch));
    Json fixes = Json::array();
    for (const WhyRow& row : why.rows)
        if (!row.fix.empty()) fixes.push_back(row.fix);
    return {{"pixel", as_json(why.chain.pixel)},
            {"say", say(why.sentence)},
            {"wrong", why.fault.empty() ? Json() : Json(say(why.fault))},
            {"predicted", why.predicted ? Json(as_text(*why.predicted)) : Json()},
            {"read_back", why.read_back ? Json(as_text(*why.read_back)) : Json()},
            {"rounding", why.chain.is_as_rounded()},
            {"surface", why.surface},
            {"casters", why.casters},
            {"fixes", std::move(fixes)},
            {"rows", std::move(rows)},
            {"fragments", std::move(touches)}};
}

}  // namespace viewing
