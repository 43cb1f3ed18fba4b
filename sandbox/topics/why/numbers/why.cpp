#include "topics/why/numbers/why.h"

#include <algorithm>
#include <array>

#include "frame/plan/draw_calls.h"
#include "frame/say.h"
#include "state/file/state_json.h"
#include "topics/depth/numbers/fragment_text.h"

namespace viewing {
namespace {

/// Returns the picture's color at the pixel with a setting applied; none if the setting cannot be tried on this scene.
std::optional<Color> color_with(const WhyQuestion& question, const std::string& setting) {
    const Result<Params> fixed = apply_settings(question.params, std::vector<std::string>{setting});
    if (!fixed || fixed->scene != question.params.scene || fixed->coplanar != question.params.coplanar)
        return std::nullopt;
    const bool needs_method = !is_drawn_by_gl_alone(fixed->visibility.method);
    if (needs_method && !question.solve) return std::nullopt;
    const Derived derived = derive(*fixed, question.finder.scene(), question.viewport);
    const FramePlan frame = plan(*fixed, derived, needs_method ? question.solve(*fixed, derived) : HiddenPictures{});
    const PixelChain chain = pixel_chain(frame, question.finder, question.pixel, question.viewport.size_px);
    return predicted_color(frame, chain);
}

/// Adds a row for each problem whose fix changes this pixel. If the problem is depth fighting at this pixel, the row
/// about the fight gets the fix.
void add_fault_rows(Why& made, const WhyQuestion& question) {
    if (!made.predicted) return;
    for (const Problem& problem : question.problems) {
        if (problem.fixed_by.empty()) continue;
        const std::optional<Color> fixed = color_with(question, problem.fixed_by);
        if (!fixed || is_same_color(*fixed, *made.predicted)) continue;
        const auto fight = std::find_if(made.rows.begin(), made.rows.end(),
                                        [](const WhyRow& row) { return row.kind == WhyRow::Kind::fight; });
        if (fight != made.rows.end() && (problem.id == "depth.fighting" || problem.id == "depth.coplanar")) {
            fight->after = fixed;
            fight->fix = problem.fixed_by;
            continue;
        }
        made.rows.push_back({.kind = WhyRow::Kind::fault,
                             .title = message("Wrong here"),
                             .sentences = {ended(problem.sentence)},
                             .after = fixed,
                             .fix = problem.fixed_by});
    }
}

/// Finds the visible surface, and the casters of the shadows on it.
void find_names(Why& made, const WhyQuestion& question) {
    const Touch* surface = made.chain.surface(question.plan);
    if (surface) made.surface = surface->fragment.object;
    for (const Touch& touch : made.chain.touches) {
        const Pass& pass = question.plan.passes[touch.fragment.pass];
        const bool is_shadow = role_of(pass) == PassRole::shadow && pass.mirrors_met.empty() && touch.fragment.passes;
        const std::string& name = touch.fragment.object;
        const bool is_on_it =
            surface ? surface->fragment.object_index == -1 - static_cast<int>(pass.plane) : touch.paints;
        if (is_shadow && is_on_it && std::find(made.casters.begin(), made.casters.end(), name) == made.casters.end())
            made.casters.push_back(name);
    }
}

/// Names the visible surface, says whether light is missing, and names what else contributes to the color.
Message sentence_of(const Why& made, const WhyQuestion& question) {
    const Touch* surface = made.chain.surface(question.plan);
    const std::vector<const Touch*> images = images_of(made, question.plan);
    const Touch* image = images.empty() ? nullptr : images.front();
    std::vector<Message> names;
    for (const std::string& caster : made.casters) names.push_back(object_message(caster));
    const Message casters = enumerated(names);
    if (!surface && !image && question.plan.shows == Shows::overdraw)
        return message("No object is drawn here; only objects count.");
    if (!surface && !image)
        return names.empty()
                   ? message("Nothing is drawn here: this is the background.")
                   : message("Seen here: the background, under the shadow of {casters}.", "casters"_a = casters);
    const Message seen = surface_name(question, (surface ? surface : image)->fragment.object_index);
    const Message said = names.empty() ? message("Seen here: {surface}.", "surface"_a = seen)
                                       : message("Seen here: {surface}, in the shadow of {casters}.",
                                                 "surface"_a = seen, "casters"_a = casters);
    if (!image || !surface) return said;
    return listed(
        {said, message("{share} of the color is the mirror image of {object}.", "share"_a = percent(image->share, 0),
                       "object"_a = surface_name(question, image->fragment.object_index))},
        " ");
}

}  // namespace

std::string hex_of(const Color& color) {
    return hex_color(color.r, color.g, color.b);
}

std::vector<const Touch*> images_of(const Why& made, const FramePlan& plan) {
    std::vector<const Touch*> images;
    for (const Touch& touch : made.chain.touches) {
        const Pass& pass = plan.passes[touch.fragment.pass];
        if (pass.is_mirror_image && is_surface(pass) && touch.share > least_share) images.push_back(&touch);
    }
    std::stable_sort(images.begin(), images.end(), [](const Touch* a, const Touch* b) { return a->share > b->share; });
    return images;
}

Why why(const WhyQuestion& question) {
    Why made;
    const glm::ivec2 size_px = question.viewport.size_px;
    made.chain = question.read_back
                     ? chain_as_rounded(question.plan, question.finder, question.pixel, size_px, *question.read_back)
                     : pixel_chain(question.plan, question.finder, question.pixel, size_px);
    made.predicted = predicted_color(question.plan, made.chain);
    made.read_back = question.read_back;
    made.has_mirror = !images_of(made, question.plan).empty();
    made.has_shadow = std::any_of(made.chain.touches.begin(), made.chain.touches.end(), [&](const Touch& touch) {
        return touch.fragment.passes && role_of(question.plan.passes[touch.fragment.pass]) == PassRole::shadow;
    });
    add_ray_row(made, question);
    add_pass_rows(made, question);
    add_mirror_rows(made, question);
    add_light_rows(made, question);
    add_fight_row(made, question);
    add_fault_rows(made, question);
    add_sample_row(made, question);
    add_sum_row(made, question);
    // The rows' colors appear only in a picture that shows colors or facing.
    if (question.plan.shows != Shows::color && question.plan.shows != Shows::facing)
        for (WhyRow& row : made.rows)
            if (row.fix.empty() && row.kind != WhyRow::Kind::sum) row.after.reset();
    find_names(made, question);
    made.sentence = sentence_of(made, question);
    const auto fault = std::find_if(made.rows.begin(), made.rows.end(),
                                    [](const WhyRow& row) { return row.kind == WhyRow::Kind::fault; });
    if (fault != made.rows.end()) made.fault = message("Wrong here: {fault}", "fault"_a = fault->sentences.front());
    return made;
}

Message why_as_text(const Why& why) {
    std::vector<Message> text{message("Pixel ({x}, {y})", "x"_a = why.chain.pixel.x, "y"_a = why.chain.pixel.y)};
    const auto add = [&text](const char* between, Message part) {
        text.insert(text.end(), {verbatim(between), std::move(part)});
    };
    if (why.read_back) add(" ", verbatim(hex_of(*why.read_back)));
    add("\n", why.sentence);
    if (!why.fault.empty()) add(" ", why.fault);
    for (const WhyRow& row : why.rows) {
        add("\n  ", row.title);
        add(": ", listed(row.sentences, " "));
        if (!row.fix.empty())
            add(" ", message("With {fix}: {color}.", "fix"_a = row.fix, "color"_a = hex_of(*row.after)));
        else if (row.after && row.kind != WhyRow::Kind::sum)
            add(" → ", verbatim(hex_of(*row.after)));
    }
    add("\n\n", {});
    return listed(text, "");
}

}  // namespace viewing
