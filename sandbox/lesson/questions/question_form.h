// Internal to lesson/: functions with which each kind of question reads its members from a file.
#pragma once

#include "lesson/questions/question_kind.h"
#include "lesson/step_reader.h"

namespace viewing {

/// Adds a step's question ("ask"); the question's kind decides which other members are read.
void add_ask(form::Object<LessonStep>& step_form, const LessonReading& reading);

/// The members that hold an example of a wrong answer. The last one counts if both are given.
inline constexpr const char* sample_keys[] = {"try", "value"};

/// Reads examples that are numbers.
void read_wrong_numbers(form::Object<LessonStep>& wrong);

template <typename V>
auto in_ask(V Ask::*member) {
    return [member](LessonStep& step) -> V& { return step.ask.*member; };
}

/// Returns an accessor for this member of the wrong answer that is being read.
template <typename V>
auto in_wrong(V WrongAnswer::*member) {
    return [member](LessonStep& step) -> V& { return step.ask.wrong.back().*member; };
}

}  // namespace viewing
