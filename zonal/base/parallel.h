#pragma once

#include <functional>
#include <vector>

#include "zonal/base/run.h"

namespace zonal {

/// A fixed piece [begin, end) of an index range. Blocks are cut by size only, so that sums which join them in index
/// order have the same bits on any number of threads.
struct Block {
  int index = 0;
  int begin = 0;
  int end = 0;
};

/// Cuts [0, count) into blocks of `block_size` and calls `work` on each, in parallel. Reports progress for `stage`
/// unless it is empty. Throws Error{kCancelled} when the run is stopped, and the exception of the first block that
/// threw.
void for_each_block(const Run& run, std::string_view stage, int count, int block_size,
                    const std::function<void(Block)>& work);

/// The same, and joins the blocks' results in index order: combine(total, part).
template <class T, class Work, class Combine>
T reduce_blocks(const Run& run, std::string_view stage, int count, int block_size, T total, Work work,
                Combine combine) {
  std::vector<T> parts(static_cast<std::size_t>((count + block_size - 1) / block_size), total);
  for_each_block(run, stage, count, block_size, [&](Block block) { parts[block.index] = work(block); });
  for (const T& part : parts) combine(total, part);
  return total;
}

}  // namespace zonal
