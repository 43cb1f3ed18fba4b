#include "ui/parts/topics.h"

#include "text/catalogue.h"

namespace viewing {
namespace {

Topic& chosen_topic(Params& params, Slot slot) {
    return slot == Slot::left ? params.view.lower_left : params.view.lower_right;
}

}  // namespace

Topic topic_of(const Params& params, Slot slot) {
    const Topic chosen = slot == Slot::left ? params.view.lower_left : params.view.lower_right;
    if (chosen != Topic::automatic) return chosen;
    if (slot == Slot::left) return Topic::observer;
    const VisibilityMethod method = params.visibility.method;
    if (method == VisibilityMethod::bsp) return Topic::tree;
    return is_drawn_by_gl_alone(method) ? Topic::depth : Topic::order;
}

void choose_topic(Params& params, Slot slot, Topic topic) {
    const Slot other = slot == Slot::left ? Slot::right : Slot::left;
    const Topic before = topic_of(params, slot);
    chosen_topic(params, slot) = topic;
    if (topic_of(params, slot) == topic_of(params, other)) chosen_topic(params, other) = before;
}

Slot telling_slot(const Params& params) {
    if (params.view.lower_left != Topic::automatic) return Slot::left;
    const bool is_usual = params.view.lower_right == Topic::automatic && topic_of(params, Slot::right) == Topic::depth;
    return is_usual ? Slot::left : Slot::right;
}

bool examines_pixel(const Params& params) {
    return is_shown(params, Topic::pixel) || is_shown(params, Topic::cells) || is_shown(params, Topic::why);
}

bool is_seen_from_outside(Topic topic) {
    return topic == Topic::observer || topic == Topic::moving_world || topic == Topic::clip || topic == Topic::way;
}

bool is_shown(const Params& params, Topic topic) {
    return topic_of(params, Slot::left) == topic || topic_of(params, Slot::right) == topic;
}

ImVec2 least_size_on_stage(Topic topic) {
    switch (topic) {
        case Topic::passes:
        case Topic::shadow_derivation:
        case Topic::cells:
        case Topic::pixel:
            return {440.0F, 150.0F};
        case Topic::lecture_code:
            return {440.0F, 190.0F};
        case Topic::why:
            return {440.0F, 370.0F};
        case Topic::mirror_derivation:
            return {440.0F, 320.0F};
        case Topic::fighting:
            return {440.0F, 185.0F};
        case Topic::display_code:
            return {440.0F, 230.0F};
        case Topic::codes:
            return {400.0F, 180.0F};
        case Topic::precision:
            return {400.0F, 150.0F};
        case Topic::tree:
            return {400.0F, 280.0F};
        default:
            return {360.0F, 150.0F};
    }
}

float lowest_on_stage(Topic topic) {
    return topic == Topic::fighting ? 158.0F : topic == Topic::precision ? 135.0F : 96.0F;
}

std::span<const char* const> topic_names() {
    static constexpr const char* names[] = {marked("Automatic"),
                                            marked("Observer"),
                                            marked("Depth buffer"),
                                            marked("Depth histogram"),
                                            marked("Depth precision"),
                                            marked("Depth codes"),
                                            marked("Pixel"),
                                            marked("Pixel grid"),
                                            marked("Depth fighting"),
                                            marked("Moving the world"),
                                            marked("GL calls, pass by pass"),
                                            marked("BSP tree"),
                                            marked("Drawing order"),
                                            marked("Cost growth"),
                                            marked("Shadow derivation"),
                                            marked("Mirror derivation"),
                                            marked("The lecture's code"),
                                            marked("Mirror, four ways"),
                                            marked("Seen from the light"),
                                            marked("The lecture's display()"),
                                            marked("Why this pixel?"),
                                            marked("Clip space"),
                                            marked("The path of a point")};
    return names;
}

}  // namespace viewing
