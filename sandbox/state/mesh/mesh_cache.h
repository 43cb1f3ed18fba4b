// Internal to state/: meshes shared between scenes, by shape and by file. Safe to use from several threads.
#pragma once

#include <filesystem>
#include <memory>

#include "platform/progress.h"
#include "state/scene.h"
#include "text/result.h"

namespace viewing {

/// Returns the mesh of an object. A mesh file is relative to `base` and is reread only if it changed. A mesh lives as
/// long as it is used; the most recently read mesh file is also kept.
Result<std::shared_ptr<const ObjMesh>> shared_mesh(const ObjectDescription& object, const std::filesystem::path& base,
                                                   WorkProgress* progress);

}  // namespace viewing
