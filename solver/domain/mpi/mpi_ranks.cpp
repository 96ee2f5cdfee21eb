// The ranks of a run that mpirun (or srun) has started. A module of its own, loaded only where there are several ranks
// (solver/program/join_ranks.cpp), so that programs run where MPI is not installed.
#include <mpi.h>
#if __has_include(<mpi-ext.h>)
#include <mpi-ext.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "common/ranks.hpp"

namespace thalweg {
namespace {

/// One message of MPI has at most so many bytes, whose number it keeps in an int.
constexpr std::size_t most_bytes = std::size_t{1} << 30;

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
    MPI_Comm_size(here, &here_);
    MPI_Comm_rank(here, &place_here_);
    MPI_Comm_free(&here);
  }
  ~MpiRanks() override { MPI_Finalize(); }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  void gather(const void* mine, std::size_t bytes, void* all) override {
    if (bytes > most_bytes) throw std::length_error("a rank's part of a gathered array is larger than 1 GiB");
    const int n = static_cast<int>(bytes);
    const Waiting waiting(waited_);
    count(1, 0, bytes);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgather(mine, n, MPI_BYTE, all, n, MPI_BYTE, MPI_COMM_WORLD, &request);
    wait_for(&request, 1);
  }

  void start_exchange(const std::vector<std::span<const std::byte>>& to,
                      const std::vector<std::span<std::byte>>& from) override {
    const Waiting waiting(waited_);
    requests_.clear();
    for (int r = 0; r < size_; ++r) {
      const auto& in = from[static_cast<std::size_t>(r)];
      if (r == rank_) {
        const auto& own = to[static_cast<std::size_t>(r)];
        std::copy(own.begin(), own.end(), in.begin());
        continue;
      }
      for (std::size_t at = 0; at < in.size(); at += most_bytes) {
        MPI_Irecv(in.data() + at, piece(in.size(), at), MPI_BYTE, r, 0, MPI_COMM_WORLD, &requests_.emplace_back());
      }
    }
    for (int r = 0; r < size_; ++r) {
      const auto& out = to[static_cast<std::size_t>(r)];
      for (std::size_t at = 0; r != rank_ && at < out.size(); at += most_bytes) {
        count(0, 1, std::min(most_bytes, out.size() - at));
        MPI_Isend(out.data() + at, piece(out.size(), at), MPI_BYTE, r, 0, MPI_COMM_WORLD, &requests_.emplace_back());
      }
    }
  }
  void progress() override { all_done(requests_.data(), static_cast<int>(requests_.size())); }
  void finish_exchange() override {
    const Waiting waiting(waited_);
    wait_for(requests_.data(), static_cast<int>(requests_.size()));
  }

  void sum(std::int64_t* numbers, std::size_t n) override { reduce(numbers, n, MPI_INT64_T, MPI_SUM); }
  void largest(std::uint8_t* numbers, std::size_t n) override { reduce(numbers, n, MPI_UINT8_T, MPI_MAX); }

  [[nodiscard]] Traffic sent() const override { return sent_; }
  [[nodiscard]] double waited() const override { return waited_; }
  [[nodiscard]] int on_this_machine() const override { return here_; }
  [[nodiscard]] int place_on_this_machine() const override { return place_here_; }

  [[nodiscard]] bool takes_device_memory() const override {
#if defined(MPIX_CUDA_AWARE_SUPPORT)
    return MPIX_Query_cuda_support() == 1;
#else
    return false;
#endif
  }

  [[noreturn]] void abandon() override {
    MPI_Abort(MPI_COMM_WORLD, 1);
    std::abort();
  }

 private:
  void count(int collectives, int messages, std::size_t bytes) {
    sent_.collectives += collectives;
    sent_.messages += messages;
    sent_.bytes += static_cast<std::int64_t>(bytes);
  }
  /// Waits in circles for about as long as a message takes, and asleep where others need the core. MPI's own waiting never
  /// sleeps, which makes more ranks than free cores a hundred times slower.
  static void wait_for(MPI_Request* requests, int n) {
    constexpr int circles = 2000;  // half a millisecond
    constexpr std::chrono::microseconds nap(50);
    for (int turn = 0; !all_done(requests, n); ++turn) {
      if (turn > circles) std::this_thread::sleep_for(nap);
    }
  }
  static bool all_done(MPI_Request* requests, int n) {
    int done = 0;
    MPI_Testall(n, requests, &done, MPI_STATUSES_IGNORE);
    return done != 0;
  }
  static int piece(std::size_t size, std::size_t at) { return static_cast<int>(std::min(most_bytes, size - at)); }

  /// Adds the time that it lives.
  class Waiting {
   public:
    explicit Waiting(double& to) : to_(to) {}
    ~Waiting() { to_ += MPI_Wtime() - begun_; }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

   private:
    double& to_;
    double begun_ = MPI_Wtime();
  };

  template <class T>
  void reduce(T* numbers, std::size_t n, MPI_Datatype type, MPI_Op op) {
    const Waiting waiting(waited_);
    count(1, 0, n * sizeof(T));
    for (std::size_t at = 0; at < n; at += most_bytes / sizeof(T)) {
      const int count = static_cast<int>(std::min(most_bytes / sizeof(T), n - at));
      MPI_Request request = MPI_REQUEST_NULL;
      MPI_Iallreduce(MPI_IN_PLACE, numbers + at, count, type, op, MPI_COMM_WORLD, &request);
      wait_for(&request, 1);
    }
  }

  int rank_ = 0;
  int size_ = 1;
  int here_ = 1;
  int place_here_ = 0;
  double waited_ = 0;  // [s]
  Traffic sent_;
  std::vector<MPI_Request> requests_;
};

}  // namespace
}  // namespace thalweg

/// The one symbol of the module; the caller owns the result.
extern "C" __attribute__((visibility("default"))) thalweg::Ranks* thalweg_join_ranks() { return new thalweg::MpiRanks; }
