#include "frame/hidden/method_choices.h"

namespace viewing {

PainterKey painter_key(SortKey key) {
    switch (key) {
        case SortKey::nearest:
            return PainterKey::nearest;
        case SortKey::farthest:
            return PainterKey::farthest;
        case SortKey::centroid:
            break;
    }
    return PainterKey::centroid;
}

BspSplitter bsp_splitter(Splitter splitter) {
    switch (splitter) {
        case Splitter::first:
            return BspSplitter::first;
        case Splitter::random:
            return BspSplitter::random;
        case Splitter::fewest_splits:
            return BspSplitter::fewest_splits;
        case Splitter::balanced:
            break;
    }
    return BspSplitter::balanced;
}

BspOrder bsp_order(BspWalkOrder order) {
    switch (order) {
        case BspWalkOrder::back_to_front:
            return BspOrder::back_to_front;
        case BspWalkOrder::front_to_back:
            break;
    }
    return BspOrder::front_to_back;
}

CulledFaces culled_faces(CullFace face) {
    switch (face) {
        case CullFace::front:
            return CulledFaces::front;
        case CullFace::back:
            return CulledFaces::back;
        case CullFace::front_and_back:
            break;
    }
    return CulledFaces::front_and_back;
}

FrontWinding front_winding(FrontFace front) {
    switch (front) {
        case FrontFace::ccw:
            return FrontWinding::counter_clockwise;
        case FrontFace::cw:
            break;
    }
    return FrontWinding::clockwise;
}

}  // namespace viewing
