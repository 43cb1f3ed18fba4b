// What an entry of a suite shows: its state found, its picture drawn, its numbers computed. Read entry_check.h for what
// they are compared with.
#pragma once

#include <string>
#include <vector>

#include "frame/problems.h"
#include "render/renderer.h"
#include "state/file/document.h"
#include "suite/suite.h"

namespace viewing {

/// Everything that the drawing rests on.
struct SuiteSubject {
    LoadedState state;
    Scene scene;
    PictureRequest request;
    Derived derived;
};

/// The error: a state, scene, lesson or setting that cannot be read.
Result<SuiteSubject> subject_of(const SuiteEntry& entry, Renderer& renderer, bool allows_outside);

/// What decides the picture and the numbers, as a text: two subjects with the same one give the same.
std::string fingerprint(const SuiteEntry& entry, const SuiteSubject& subject);

std::vector<Problem> problems_of(const SuiteSubject& subject);

/// {"matrices": …, "measure": {"fighting": …}}, what the entry checks of it; null when it checks none.
Result<Json> numbers_of_entry(const SuiteEntry& entry, const SuiteSubject& subject,
                              const std::vector<Problem>& problems, Renderer& renderer);

}  // namespace viewing
