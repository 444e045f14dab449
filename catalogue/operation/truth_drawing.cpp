// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/truth_drawing.h"

#include <algorithm>

#include "catalogue/draw/by_shape.h"
#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {
namespace {

/// The truth, its points and segments rounded for the eye.
class AnswerDrawing {
 public:
  AnswerDrawing(Drawing& drawing, const Examination& question)
      : drawing_(drawing),
        exact_(question.solution().answer),
        at_(question.nearest_truth()),
        has_arrows_(std::any_of(drawing.space.begin(), drawing.space.end(), [](const SpaceFigure& figure) {
          return figure.answer && figure.kind == SpaceFigure::Kind::arrow;
        })) {}

  void draw(const Shape& shape, const std::string& label) {
    if (has_figure(shape)) {
      const std::size_t before = drawing_.space.size();
      draw_figure(drawing_, shape, label, at_, true);
      // Vectors that the row has drawn at their positions are noted in words, and not drawn again at the origin.
      if (has_arrows_ && drawing_.space.size() > before && drawing_.space.back().kind == SpaceFigure::Kind::arrow)
        drawing_.space.resize(before);
      return pass(shape);
    }
    switch (shape.kind) {
      case Shape::Kind::optional:
        if (*at_.word++ != 0) ++exact_.word, draw(*shape.parts[0].shape, label);
        else ++exact_.word;
        return;
      case Shape::Kind::word:
        drawing_.notes.push_back(label + ": " + shape.words[*at_.word++]);
        ++exact_.word;
        return;
      case Shape::Kind::number:
        drawing_.notes.push_back(label + " = " + in_words(*exact_.number++));
        ++at_.number;
        return;
      case Shape::Kind::record:
        if (shape.form == Form::bare) break;
        for (const Shape::Part& part : shape.parts) draw(*part.shape, part.name);
        return;
      case Shape::Kind::choice: {
        const Word which = *at_.word++;
        ++exact_.word;
        return draw(*shape.parts[which].shape, label);
      }
      default: break;
    }
    const Cursor<TrueNumber> before = exact_;
    drawing_.notes.push_back(
        label + ": " + one_line(json_of<TrueNumber>(shape, exact_, [](const TrueNumber& n) { return written(n); })));
    at_.number += exact_.number - before.number;
    at_.word += exact_.word - before.word;
  }

 private:
  static std::string in_words(const TrueNumber& number) { return written(number).get<std::string>(); }
  /// Moves the exact cursor as far as the other one has been moved.
  void pass(const Shape& shape) {
    struct Nothing {
      void number(const Shape&, const Cursor<TrueNumber>&) {}
      void word(const Shape&, const Cursor<TrueNumber>&) {}
    } nothing;
    walk_encoded(shape, exact_, nothing);
  }

  Drawing& drawing_;
  Cursor<TrueNumber> exact_;
  Cursor<double> at_;
  bool has_arrows_;
};

}  // namespace

Drawing drawing_of(const Examination& question) {
  const RowFunctions& row = question.row();
  Drawing drawing;
  if (row.draw != nullptr) {
    row.draw(drawing, question.question(), question.nearest_truth());
  } else {
    draw_question(drawing, question.operation().question_shape(), question.question());
  }
  AnswerDrawing(drawing, question).draw(*row.answer, row.metadata->answer);
  return drawing;
}

Drawing drawing_of_refused(const Operation& operation, const Question& question, const InvalidInput& refused) {
  Drawing drawing;
  draw_question(drawing, operation.question_shape(), question);
  drawing.notes.push_back(refused.what());
  return drawing;
}

}  // namespace touchstone::catalogue
