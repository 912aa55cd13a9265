// A fixed set of threads that work through the particles.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_

#include <functional>
#include <memory>

namespace gmapping_spa::particle_filter {

// Which thread does what is not defined, so items must neither share state nor throw.
class ParallelFor {
 public:
  // `threads` >= 1; with 1 everything runs in the calling thread.
  explicit ParallelFor(int threads);
  ~ParallelFor();

  // Calls work(0) ... work(count - 1) and returns when all are done.
  void operator()(int count, const std::function<void(int)>& work);

 private:
  struct Pool;
  std::unique_ptr<Pool> pool_;  // none for a single thread
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_
