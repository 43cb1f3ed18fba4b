#include "ui/window/topics.h"

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

bool is_shown(const Params& params, Topic topic) {
    return topic_of(params, Slot::left) == topic || topic_of(params, Slot::right) == topic;
}

std::span<const char* const> topic_names() {
    static constexpr const char* names[] = {"Automatic",
                                            "Observer",
                                            "Depth buffer",
                                            "Depth histogram",
                                            "Depth precision",
                                            "Depth codes",
                                            "Pixel",
                                            "Pixels as cells",
                                            "Depth fighting",
                                            "Moving the world",
                                            "GL calls, pass by pass",
                                            "BSP tree",
                                            "Drawing order",
                                            "Costs as they grow",
                                            "Shadow, derived",
                                            "Mirror, derived",
                                            "The lecture's code",
                                            "Mirror, four ways",
                                            "Seen from the light"};
    return names;
}

}  // namespace viewing
