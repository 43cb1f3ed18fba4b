#include "ui/parts/topics.h"

#include "topics/hidden/numbers/hidden_method.h"

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
    if (hidden_method(method).has_tree) return Topic::tree;
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

bool names_both_topics(const Params& params) {
    return params.view.lower_left != Topic::automatic && params.view.lower_right != Topic::automatic;
}

bool is_shown(const Params& params, Topic topic) {
    return topic_of(params, Slot::left) == topic || topic_of(params, Slot::right) == topic;
}

}  // namespace viewing
