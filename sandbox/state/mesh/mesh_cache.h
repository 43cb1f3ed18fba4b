// Internal to state/: meshes shared between scenes, by shape and by file. Safe to use from several threads.
#pragma once

#include <filesystem>
#include <memory>

#include "platform/progress.h"
#include "state/scene.h"
#include "text/result.h"

namespace viewing {

/// The mesh of an object; a mesh file is looked up from `base` and read again only when it changed. Shapes live as long
/// as somebody uses them; the mesh file that was read last is kept besides.
Result<std::shared_ptr<const ObjMesh>> shared_mesh(const ObjectDescription& object, const std::filesystem::path& base,
                                                   WorkProgress* progress);

}  // namespace viewing
