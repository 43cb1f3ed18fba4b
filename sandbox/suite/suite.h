// A suite: pictures and numbers of states that are to stay as they are. Read suite_reader.cpp for the file that says
// so, entry_check.h for what happens to one entry, run.h for all of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/picture.h"
#include "image/compare.h"
#include "image/mask_source.h"

namespace viewing {

/// What is drawn in place of a state: a step of a lesson, or a student's exercise.
struct SuiteStep {
    std::string lesson;  ///< a name or a file; empty: an exercise
    int step = 1;
    bool revealed = false, presents = false;
    std::string exercise, course, student;
};

/// What is measured, with how far a number may be off: absolutely, or as a share of the expected one.
struct SuiteMeasure {
    std::string what;  ///< fighting, visibility, mirror, order
    double tolerance = 0.0;
};

struct SuiteEntry {
    std::string name;       ///< as the suite has it
    std::string about;      ///< why it is there, and behind that why its thresholds are loosened; "" where nobody says
    std::string file_name;  ///< the same, safe on every file system: of its reference and results, without an ending

    std::string state;         ///< as a command takes it; files as full paths
    std::string inline_state;  ///< JSON, in place of `state`; "": none
    std::optional<SuiteStep> step;
    std::vector<std::string> settings;  ///< on top, in order

    PictureView view = PictureView::camera;
    glm::ivec2 size_px{640, 360};
    std::optional<int> samples;  ///< left out: as the state says

    bool checks_picture = true;
    CompareOptions limits;
    MaskSource mask;                           ///< what is not compared of the picture
    std::optional<double> matrices_tolerance;  ///< none: matrices are not checked
    std::vector<SuiteMeasure> measures;
    std::vector<std::string> wanted_problems;  ///< parts of sentences, each of which must be told
    std::vector<std::string> unwanted_problems;
    bool allows_no_problem = false;
};

struct Suite {
    std::string name;
    std::filesystem::path argument;  ///< the file, or the folder of states
    std::filesystem::path folder;    ///< what its paths are relative to
    std::filesystem::path references, report;
    std::vector<SuiteEntry> entries;
};

/// A suite's file, or a folder whose states are its entries with all defaults. The error is one sentence with file and
/// field. States that are files are read when their turn comes: one that is broken fails its own entry.
Result<Suite> load_suite(const std::string& argument);

/// Whether all masks can be read and leave something of their entry's picture to compare. One sentence with the entry.
Status check_masks(const Suite& suite);

/// A name as a part of a file's name: letters, digits, - and _ as they are, a dot inside, a space or slash as -, others
/// as %XX; never one that a file system keeps for itself; at most 150 bytes.
std::string safe_file_name(const std::string& name);

}  // namespace viewing
