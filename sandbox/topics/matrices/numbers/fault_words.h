// The faults of pasted matrices in words, for the command line (in English) and the window.
#pragma once

#include "topics/matrices/numbers/explain_matrix.h"

namespace viewing {

/// A fault's name in JSON, what is wrong, and the fix; the last two are marked for translation.
struct FaultWords {
    const char* name;
    const char* wrong;
    const char* fix;
};

FaultWords fault_words(const ExplainedMatrix& found);

/// Returns the name of a matrix of the lecture: "V, view_from_world"; marked for translation.
const char* matrix_title(char letter);

}  // namespace viewing
