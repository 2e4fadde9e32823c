#include "adapt/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <utility>

namespace pectin {

void for_pieces_on_all_threads(std::uint32_t first, std::uint32_t end, std::uint32_t piece,
                               const Piece& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(first, end, piece),
        [&](const tbb::blocked_range<std::uint32_t>& range) { work(range.begin(), range.end()); },
        tbb::static_partitioner());
}

struct Meanwhile::Group {
    tbb::task_group tasks;
};

Meanwhile::Meanwhile() = default;

Meanwhile::~Meanwhile() {
    if (running_) group_->tasks.wait();
}

void Meanwhile::run(std::function<void()> work) {
    if (!group_) group_ = std::make_unique<Group>();
    group_->tasks.run(std::move(work));
    running_ = true;
}

void Meanwhile::wait() {
    if (running_) group_->tasks.wait();
    running_ = false;
}

}  // namespace pectin
