// A desk with a finished exercise sheet. The sheet is made as in the studio but without pictures, so parts that must be
// measured are missing.
#pragma once

#include <map>

#include "desk.h"
#include "grading/state_numbers.h"

namespace viewing::test {

class ExerciseSheetDesk : public Desk {
public:
    explicit ExerciseSheetDesk(ImVec2 size, const Student& student = {"viewing-2026", "32201234", "Kim"}) : Desk(size) {
        workbench.exercises.desk.sit_down(student);
        workbench.exercises.desk.open();
        make();
    }
    /// Makes the step of every exercise; an exercise that needs measurements gets an error instead.
    void make() {
        static std::map<std::pair<std::string, std::size_t>, Result<LessonStep>> made;  // the same for every desk
        ExerciseDesk& desk = workbench.exercises.desk;
        while (const std::optional<std::size_t> next = desk.next_to_make()) {
            const ExerciseDesk::Entry& entry = desk.entries()[*next];
            auto known = made.find({entry.exercise.id, entry.variant});
            if (known == made.end())
                known = made.emplace(std::pair(entry.exercise.id, entry.variant),
                                     variant_step(entry.exercise, entry.variant, numbers_at_start(nullptr)))
                            .first;
            desk.take_step(*next, known->second);
        }
    }
    void begin(const std::string& id) {
        workbench.exercises.go_to(id, false);
        settle();
        apply_looks();
        ui.move_to({-1, -1});
        ui.frames(3);
    }
    LessonRun& run() { return *workbench.guide.run(); }
    /// Does what the studio does after Check is pressed, for everything that needs no picture.
    void check() {
        const LessonStep& step = run().step();
        const Params& judged = step.ask.kind == AskKind::goal ? session.params : step.start.params;
        LessonNumbers numbers(judged, step.start.params, session.scene(), nullptr);
        const Result<Verdict> verdict = judge(step.ask, run().answer(), numbers.surroundings());
        if (!verdict) throw std::runtime_error(verdict.error());
        run().take(*verdict);
        workbench.exercises.desk.record(run(), *verdict, session.params);
        ui.frames(3);
    }
};

}  // namespace viewing::test
