// The card at the end of a lesson: three sentences about what was seen, followed by the lessons that this one builds on
// and what comes next.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lesson/lesson_run.h"
#include "ui/lesson/start_page.h"

namespace viewing {

class EndCard {
public:
    struct Wishes {
        bool back = false, next = false, overview = false;
        std::string lesson;    ///< the lesson to begin; "" for none
        std::string exercise;  ///< the exercise to open; "" for none
    };
    /// Draws the card over the whole window. `presents`: for an audience, without buttons.
    Wishes draw(const LessonRun& run, bool presents, const Pictures& pictures);
    /// Returns the picture that the card shows: the first step of the lesson or, in a lecture, of the current part,
    /// after the step's answer.
    static CardPicture wanted_picture(const LessonRun& run);
    /// Returns the card's texts that do not occur in any lesson's steps, so that the fonts can be loaded with their
    /// characters.
    std::vector<std::string> texts(const LessonRun& run);

private:
    /// Reads the titles of other files, once for each card.
    void read(const LessonRun& run);
    void draw_what_follows(bool presents, float width, Wishes& wishes) const;

    const LessonEnd* of_ = nullptr;
    std::shared_ptr<const Lesson> lesson_;  ///< keeps *of_ alive
    std::optional<LessonFile> next_;        ///< the lesson that follows in the course
    std::vector<LessonText> needs_;         ///< the titles of the lessons that this one needs
    LessonText next_part_, exercise_;
};

}  // namespace viewing
