// The parameters' choices as the methods of visibility/ name them: the two rooms do not know each other.
#pragma once

#include "state/params.h"
#include "visibility/bsp.h"
#include "visibility/culling.h"
#include "visibility/painter.h"

namespace viewing {

PainterKey painter_key(SortKey key);
BspSplitter bsp_splitter(Splitter splitter);
BspOrder bsp_order(BspWalkOrder order);
CulledFaces culled_faces(CullFace face);
FrontWinding front_winding(FrontFace front);

}  // namespace viewing
