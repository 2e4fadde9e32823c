#include "adapt/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace pectin {

void for_pieces_on_all_threads(std::uint32_t first, std::uint32_t end, std::uint32_t piece,
                               const Piece& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(first, end, piece),
        [&](const tbb::blocked_range<std::uint32_t>& range) { work(range.begin(), range.end()); },
        tbb::static_partitioner());
}

}  // namespace pectin
