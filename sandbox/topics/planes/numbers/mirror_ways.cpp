#include "topics/planes/numbers/mirror_ways.h"

#include "text/catalogue.h"
#include "text/per_enum.h"

namespace viewing {

Params mirrored_in(Params params, MirrorWay way) {
    ReflectionParams& reflection = params.reflection;
    reflection.clip = way == MirrorWay::none      ? MirrorClip::none
                      : way == MirrorWay::oblique ? MirrorClip::oblique
                                                  : MirrorClip::clip_distance;
    reflection.mirrored = way == MirrorWay::camera ? MirroredThing::camera : MirroredThing::scene;
    return params;
}

const char* name_of(MirrorWay way) {
    static constexpr auto names = per_enum<MirrorWay>(marked("clip distance"), marked("no clipping"),
                                                      marked("oblique near plane"), marked("mirrored camera"));
    return names[way];
}

}  // namespace viewing
