// How far a long piece of work has come, and the wish that it end.
#pragma once

#include <exception>
#include <functional>
#include <stop_token>
#include <utility>

namespace pectin {

// Work that was stopped by whoever asked for it: nothing is wrong and nothing has changed.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

// Handed down to long work, which calls advance() often. The one that has neither a callback nor
// a way to be stopped costs nothing.
class Progress {
  public:
    Progress() = default;
    // report: called on the working thread with a fraction from 0 to 1 that never falls.
    Progress(std::stop_token stop, std::function<void(double)> report)
        : stop_(std::move(stop)), report_(std::move(report)) {}

    // Throws Cancelled where the work is to end. fraction: of this piece of the work.
    void advance(double fraction) const {
        if (stop_.stop_requested()) throw Cancelled();
        if (report_) report_(begin_ + fraction * (end_ - begin_));
    }
    // The part [begin, end] of this work, as a whole of its own.
    Progress part(double begin, double end) const {
        Progress piece = *this;
        piece.begin_ = begin_ + begin * (end_ - begin_);
        piece.end_ = begin_ + end * (end_ - begin_);
        return piece;
    }

  private:
    std::stop_token stop_;
    std::function<void(double)> report_;
    double begin_ = 0.0, end_ = 1.0;
};

}  // namespace pectin
