#include "frontend/particle_filter/parallel_for.h"

#include <glog/logging.h>

#include <unsupported/Eigen/CXX11/ThreadPool>

namespace gmapping_spa::particle_filter {

struct ParallelFor::Pool {
  // Waiting threads sleep: spinning would count as CPU time of the filter.
  explicit Pool(int threads) : eigen(threads, /*allow_spinning=*/false) {}
  Eigen::ThreadPool eigen;
};

ParallelFor::ParallelFor(int threads) {
  CHECK_GE(threads, 1);
  if (threads > 1) pool_ = std::make_unique<Pool>(threads);
}

ParallelFor::~ParallelFor() = default;

void ParallelFor::operator()(int count, const std::function<void(int)>& work) {
  if (!pool_) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  Eigen::Barrier done(count);
  for (int i = 0; i < count; ++i) {
    pool_->eigen.Schedule([&work, &done, i] {
      work(i);
      done.Notify();
    });
  }
  done.Wait();
}

}  // namespace gmapping_spa::particle_filter
