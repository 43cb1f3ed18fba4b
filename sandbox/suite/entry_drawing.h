// Loads everything that is needed to draw an entry of a suite, and computes the entry's numbers. See entry_check.h for
// the comparison.
#pragma once

#include <string>
#include <vector>

#include "frame/problems.h"
#include "render/renderer.h"
#include "state/file/document.h"
#include "suite/suite.h"

namespace viewing {

/// Everything that is needed to draw an entry.
struct SuiteSubject {
    LoadedState state;
    Scene scene;
    PictureRequest request;
    Derived derived;
};

/// Loads the entry. Fails if a state, scene, lesson or setting cannot be read.
Result<SuiteSubject> subject_of(const SuiteEntry& entry, Renderer& renderer, bool allows_outside);

/// Returns everything that determines the picture and the numbers, as text: equal texts mean equal results.
std::string fingerprint(const SuiteEntry& entry, const SuiteSubject& subject);

std::vector<Problem> problems_of(const SuiteSubject& subject);

/// Returns {"matrices": …, "measure": {"fighting": …}} with the parts that the entry checks; null if it checks none.
Result<Json> numbers_of_entry(const SuiteEntry& entry, const SuiteSubject& subject,
                              const std::vector<Problem>& problems, Renderer& renderer);

}  // namespace viewing
