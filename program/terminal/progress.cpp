// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/counted.h"
#include "audit/counting/cases_of.h"

namespace touchstone::program {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds rewritten_after{0.1}, line_after{10};
/// Before that an estimate of the remaining time is a guess.
constexpr Seconds least_known{2};
constexpr double least_done = 0.01;

}  // namespace

std::string in_words(Seconds time) {
  const double seconds = std::max(1.0, time.count());
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.0f} h", seconds / 3600);
}

std::string in_words(const Pace& pace) {
  return fmt::format("{:.0f} %, {}, {} a second, about {} left", 100 * pace.part, counted(pace.done, pace.noun),
                     grouped(static_cast<std::uint64_t>(pace.rate)), in_words(Seconds(pace.seconds_left)));
}

Progress::Progress(std::ostream& err, bool terminal, const std::vector<const Operation*>& operations,
                   std::uint64_t cases, std::function<Clock::time_point()> now)
    : err_(err), terminal_(terminal), cases_(cases), now_(std::move(now)), started_(now_()), last_(started_) {
  for (const Operation* operation : operations) shares_.push_back({operation});
  share_out();
}

void Progress::share_out() {
  double whole = 0;
  for (Share& share : shares_) {
    share.cases = cases_of(*share.operation, cases_, by_cost_);
    share.weight = static_cast<double>(share.operation->metadata().cost) *
                   static_cast<double>(std::max<std::uint64_t>(1, share.cases));
    share.before = whole;
    whole += share.weight;
  }
  for (Share& share : shares_) share.before /= whole, share.weight /= whole;
}

void Progress::ask_by_cost() {
  const std::lock_guard lock(mutex_);
  by_cost_ = true;
  share_out();
}

Progress::~Progress() { end(); }

void Progress::leave_out(const std::function<bool(const Operation&)>& not_asked) {
  const std::lock_guard lock(mutex_);
  std::erase_if(shares_, [&](const Share& share) { return not_asked(*share.operation); });
  share_out();
}

void Progress::end() {
  const std::lock_guard lock(mutex_);
  if (terminal_ && shown_) err_ << "\r\x1b[K" << std::flush;
  shown_ = false, ended_ = true;
}

void Progress::show(const std::string& text, Clock::time_point now) {
  if (now - last_ < (terminal_ ? rewritten_after : line_after)) return;
  last_ = now;
  shown_ = true;
  if (terminal_) err_ << "\r\x1b[K" << text << std::flush;
  else err_ << "touchstone: " << text << std::endl;
}

const Progress::Share* Progress::share_of(const std::string& operation) const {
  const auto found = std::find_if(shares_.begin(), shares_.end(),
                                  [&](const Share& share) { return share.operation->name() == operation; });
  return ended_ || found == shares_.end() ? nullptr : &*found;
}

void Progress::operator()(const std::string& operation, std::uint64_t done) {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = now_();
  if (const Share* share = share_of(operation)) show(line(*share, done, now), now);
}

void Progress::smaller(const std::string& operation, std::size_t done, std::size_t all) {
  const std::lock_guard lock(mutex_);
  const Share* share = share_of(operation);
  if (share == nullptr) return;
  show(fmt::format("{}, making {} smaller: {} of {}", place(*share, done_with(*share, 1)), counted(all, "finding"),
                   done, all),
       now_());
}

void Progress::tell(const std::string& text) {
  const std::lock_guard lock(mutex_);
  show(text, now_());
}

void Progress::step(const std::string& what, const std::string& name, std::size_t done, std::size_t all) {
  const std::lock_guard lock(mutex_);
  show(fmt::format("{}: {} of {}, {}", what, done, all, name), now_());
}

std::string Progress::place(const Share& share, double whole) const {
  return fmt::format("{:.0f} %, {} ({} of {})", 100 * whole, share.operation->name(), &share - shares_.data() + 1,
                     shares_.size());
}

std::string Progress::line(const Share& share, std::uint64_t done, Clock::time_point now) const {
  const double part = share.cases > 0 ? std::min(1.0, static_cast<double>(done) / static_cast<double>(share.cases)) : 0;
  const double whole = done_with(share, part);
  std::string text = place(share, whole);
  const Seconds spent = now - started_;
  if (spent >= least_known && whole >= least_done)
    text += ", about " + in_words(spent * ((1 - whole) / whole)) + " left";
  return text;
}

}  // namespace touchstone::program
