// Reports the progress of long work and lets it be cancelled.
#pragma once

#include <exception>
#include <functional>
#include <stop_token>
#include <utility>

namespace pectin {

// Thrown when the caller has cancelled the work. Nothing has changed then.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

// Passed to long work, which calls advance() often. A default-constructed Progress does nothing.
class Progress {
  public:
    Progress() = default;
    // report: called on the working thread with a fraction in [0, 1] that never decreases.
    Progress(std::stop_token stop, std::function<void(double)> report)
        : stop_(std::move(stop)), report_(std::move(report)) {}

    // Reports the finished fraction of this part of the work. Throws Cancelled if stop is
    // requested.
    void advance(double fraction) const {
        if (stop_.stop_requested()) throw Cancelled();
        if (report_) report_(begin_ + fraction * (end_ - begin_));
    }
    bool is_stop_requested() const { return stop_.stop_requested(); }
    // The progress of the part [begin, end] of this work; its own fractions run from 0 to 1.
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
