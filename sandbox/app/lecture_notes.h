// The lecturer's notes beside the window: in the terminal that started it, or in a file that another program shows.
#pragma once

#include <string>

#include "session/guide.h"

namespace viewing {

class LectureNotes {
public:
    /// "terminal", a file, or "" for none.
    explicit LectureNotes(std::string target) : target_(std::move(target)) {}

    /// Writes the page when it has changed. A file is replaced whole. The error says why it cannot be.
    Status follow(const Guide& guide, const Session& session, double presented_s);

private:
    std::string target_, last_;
};

}  // namespace viewing
