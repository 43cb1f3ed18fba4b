// The audience's votes, drawn over the stage: the lecturer types the counts, and bars show each choice's share. Read
// lesson/votes.h first.
#pragma once

#include <string>

#include "lesson/lesson_run.h"
#include "ui/parts/input.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Returns the digit that a key types, or −1.
int digit_of(Key key);

class VotePanel {
public:
    bool is_shown() const { return is_shown_; }
    /// Whether letters and digits are typed into the counts instead of acting as shortcuts.
    bool is_typing() const { return is_typing_; }
    void close();

    /// Handles a key. Returns true if the votes used the key.
    bool take(const KeyPress& press, LessonRun& run);

    /// Draws the votes into the lower right corner of `room`.
    void draw(const LessonRun& run, const Rect& room) const;

private:
    bool type(const KeyPress& press, Ballot& ballot);
    /// Takes the typed counts and ends typing. If they cannot be read, says why, and typing goes on.
    void enter(Ballot& ballot);
    void end_typing();

    bool is_shown_ = false, is_typing_ = false;
    std::string typed_, trouble_;
};

}  // namespace viewing
