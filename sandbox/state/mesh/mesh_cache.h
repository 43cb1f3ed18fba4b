// Internal to state/: meshes shared between scenes, by shape and by file. Safe to use from several threads.
#pragma once

#include <filesystem>
#include <memory>

#include "platform/progress.h"
#include "state/scene.h"
#include "text/result.h"

namespace viewing {

/// Returns the mesh of an object. The path of a mesh file is relative to `base`; the file is read again only if it has
/// changed. A mesh lives as long as it is in use; the mesh of the most recently read file is always kept.
Result<std::shared_ptr<const ObjMesh>> shared_mesh(const ObjectDescription& object, const std::filesystem::path& base,
                                                   WorkProgress* progress);

}  // namespace viewing
