// The methods that GL draws: with its depth test, and without any. Their order is the scene's.
#include "frame/hidden/method_parts.h"

namespace viewing {

const HiddenMethod hidden_methods::depth_buffer{.find = find_scene_order};
const HiddenMethod hidden_methods::none{.find = find_scene_order};

}  // namespace viewing
