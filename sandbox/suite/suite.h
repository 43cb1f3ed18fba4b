// A suite: states whose pictures and numbers must not change. See suite_reader.cpp for the file format, entry_check.h
// for the check of one entry, and suite_run.h for the run of all entries.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/picture.h"
#include "image/compare.h"
#include "image/mask_source.h"

namespace viewing {

/// The subject of an entry without a state: a step of a lesson, or a student's exercise.
struct SuiteStep {
    std::string lesson;  ///< a name or a file; empty for an exercise
    int step = 1;
    bool revealed = false, presents = false;
    std::string exercise, course, student;
};

/// A measurement, and the tolerance of its numbers: absolute, or relative to the expected number.
struct SuiteMeasure {
    std::string what;  ///< fighting, visibility, mirror, order
    double tolerance = 0.0;
};

struct SuiteEntry {
    std::string name;   ///< as in the suite
    std::string about;  ///< the purpose of the entry, then the reason why its thresholds are loosened; "" if not given
    std::string
        file_name;  ///< the name of its reference and results, valid on every file system, without its extension

    std::string state;         ///< in the form that commands take; the path of a file includes the suite's folder
    std::string inline_state;  ///< JSON that replaces `state`; "" if there is none
    std::optional<SuiteStep> step;
    std::vector<std::string> settings;  ///< applied in order

    PictureView view = PictureView::camera;
    glm::ivec2 size_px{640, 360};
    std::optional<int> samples;  ///< empty: as in the state

    bool checks_picture = true;
    CompareOptions limits;
    MaskSource mask;                           ///< parts of the picture that are not compared
    std::optional<double> matrices_tolerance;  ///< empty: matrices are not checked
    std::vector<SuiteMeasure> measures;
    std::vector<std::string> wanted_problems;  ///< ids or parts of sentences; each must occur in a reported problem
    std::vector<std::string> unwanted_problems;
    bool allows_no_problem = false;
};

struct Suite {
    std::string name;
    std::filesystem::path argument;  ///< the suite's file, or the folder of states
    std::filesystem::path folder;    ///< the base folder for relative paths
    std::filesystem::path references, report;
    std::vector<SuiteEntry> entries;
};

/// Loads a suite's file, or a folder whose states become entries with default settings. The error is one sentence that
/// names the file and the field. State files are read later, so that a damaged one fails only its own entry.
Result<Suite> load_suite(const std::string& argument);

/// Returns the JSON Schema of suite files.
std::string suite_schema();

/// Checks that all masks can be read and leave something to compare in their entry's picture. The error names the
/// entry.
Status check_masks(const Suite& suite);

/// Returns a name for use in a file name. Keeps letters, digits, -, _ and inner dots, and writes a space or slash as -
/// and other characters as %XX. Avoids names that a file system reserves, and shortens the result to about 150 bytes.
std::string safe_file_name(const std::string& name);

}  // namespace viewing
