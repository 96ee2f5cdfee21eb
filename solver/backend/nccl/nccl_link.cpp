// Messages between the GPUs of ranks by NCCL. A module of its own, loaded only where a run asks for it
// (solver/simulation/message_way.cpp), so that programs run where NCCL is not installed.
#include <cuda_runtime.h>
#include <nccl.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <string>
#include <thread>
#include <utility>

#include "common/error.hpp"
#include "solver/backend/device_link.hpp"

namespace thalweg {
namespace {

using Seconds = std::chrono::duration<double>;

/// All ranks make a link at the same moment; NCCL finds its network meanwhile.
constexpr Seconds longest_start(120);
/// Messages of a rank that has failed are not waited for at the end.
constexpr Seconds longest_end(10);

void check(cudaError_t status, const char* call) {
  if (status != cudaSuccess) throw RunError(std::string(call) + ": " + cudaGetErrorString(status));
}

/// A stream whose kernels go before those of the sweep: a message takes few blocks, and the other GPU waits for it.
class Stream {
 public:
  Stream() {
    int lowest = 0;
    int highest = 0;
    check(cudaDeviceGetStreamPriorityRange(&lowest, &highest), "cudaDeviceGetStreamPriorityRange");
    check(cudaStreamCreateWithPriority(&stream_, cudaStreamNonBlocking, highest), "cudaStreamCreateWithPriority");
  }
  ~Stream() { cudaStreamDestroy(stream_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  [[nodiscard]] cudaStream_t get() const { return stream_; }

 private:
  cudaStream_t stream_ = nullptr;
};

/// A moment in one stream that another one waits for.
class Moment {
 public:
  Moment() { check(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming), "cudaEventCreateWithFlags"); }
  ~Moment() { cudaEventDestroy(event_); }
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;
  void record(cudaStream_t in) { check(cudaEventRecord(event_, in), "cudaEventRecord"); }
  void hold(cudaStream_t other) { check(cudaStreamWaitEvent(other, event_, 0), "cudaStreamWaitEvent"); }

 private:
  cudaEvent_t event_ = nullptr;
};

/// A communicator of NCCL whose calls do not wait: one that waited would do so for ever for a rank that has failed. After an
/// error it is aborted at once, so that its connections close and the other ranks see an error, too.
class Communicator {
 public:
  Communicator(const ncclUniqueId& meeting, int rank, int size) {
    ncclConfig_t config = NCCL_CONFIG_INITIALIZER;
    config.blocking = 0;
    settle(ncclCommInitRankConfig(&comm_, size, meeting, rank, &config), "ncclCommInitRankConfig", longest_start);
  }
  ~Communicator() {
    if (comm_ == nullptr) return;
    const bool in_order = std::uncaught_exceptions() == 0;
    if (in_order && outcome(ncclCommFinalize(comm_), longest_end) == ncclSuccess) {
      ncclCommDestroy(comm_);
    } else {
      abort();
    }
  }
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  [[nodiscard]] ncclComm_t get() const { return comm_; }

  /// Until NCCL is done with a call. Of steps without a limit: another rank may come late, because it writes a file.
  void settle(ncclResult_t result, const char* call, Seconds longest = Seconds::max()) {
    result = outcome(result, longest);
    if (result == ncclSuccess) return;
    std::string problem = std::string(call) + ": ";
    problem += result == ncclInProgress ? "no answer from all ranks in time" : ncclGetErrorString(result);
    const char* const more = comm_ == nullptr ? nullptr : ncclGetLastError(comm_);
    if (more != nullptr && *more != '\0') problem += std::string(" (") + more + ")";
    abort();
    throw RunError(problem);
  }
  void abort() noexcept {
    if (comm_ != nullptr) ncclCommAbort(std::exchange(comm_, nullptr));
  }

 private:
  /// Waits for a call's result; ncclInProgress if that takes longer.
  ncclResult_t outcome(ncclResult_t result, Seconds longest) {
    constexpr int circles = 2000;  // as a rank waits for messages of MPI (solver/domain/mpi/mpi_ranks.cpp)
    constexpr std::chrono::microseconds nap(50);
    const auto begun = std::chrono::steady_clock::now();
    for (int turn = 0; result == ncclInProgress && comm_ != nullptr; ++turn) {
      if (ncclCommGetAsyncError(comm_, &result) != ncclSuccess) return ncclInternalError;
      if (turn < circles) continue;
      if (std::chrono::steady_clock::now() - begun > longest) return result;
      std::this_thread::sleep_for(nap);
    }
    return result;
  }

  ncclComm_t comm_ = nullptr;
};

class NcclLink final : public DeviceLink {
 public:
  NcclLink(const ncclUniqueId& meeting, int rank, int size, cudaStream_t work)
      : work_(work), communicator_(meeting, rank, size) {}

  void start(const std::vector<std::span<const std::byte>>& to,
             const std::vector<std::span<std::byte>>& from) override {
    require_whole();
    written_.record(work_);
    written_.hold(beside_.get());
    ncclResult_t first = ncclGroupStart();
    const char* call = "ncclGroupStart";
    const auto note = [&](ncclResult_t result, const char* of) {
      const bool goes_well = result == ncclSuccess || result == ncclInProgress;
      if (!goes_well && (first == ncclSuccess || first == ncclInProgress)) first = result, call = of;
    };
    for (std::size_t r = 0; r < to.size(); ++r) {
      const int other = static_cast<int>(r);
      if (!to[r].empty()) {
        note(ncclSend(to[r].data(), to[r].size(), ncclChar, other, communicator_.get(), beside_.get()), "ncclSend");
      }
      if (!from[r].empty()) {
        note(ncclRecv(from[r].data(), from[r].size(), ncclChar, other, communicator_.get(), beside_.get()), "ncclRecv");
      }
    }
    const ncclResult_t ended = ncclGroupEnd();  // also after an error, or the thread stays in the group
    communicator_.settle(first, call);
    communicator_.settle(ended, "ncclGroupEnd");
    arrived_.record(beside_.get());
  }

  void finish() override {
    require_whole();
    arrived_.hold(work_);
  }

  void give_up() noexcept override { communicator_.abort(); }

 private:
  /// NCCL notices by itself, and late, that another rank or a connection is gone.
  void require_whole() {
    if (communicator_.get() == nullptr) throw RunError("NCCL: the link to the other GPUs is gone");
    communicator_.settle(ncclInProgress, "ncclCommGetAsyncError");
  }

  cudaStream_t work_;
  Stream beside_;  // on which messages travel while the sweep goes on
  Moment written_;
  Moment arrived_;
  Communicator communicator_;  // ends before its stream
};

class NcclLinks final : public LinkMaker {
 public:
  LinkPart part(bool is_first) override {
    LinkPart mine;
    int device = 0;
    cudaDeviceProp about{};
    check(cudaGetDevice(&device), "cudaGetDevice");
    check(cudaGetDeviceProperties(&about, device), "cudaGetDeviceProperties");
    static_assert(sizeof(about.uuid.bytes) == sizeof(mine.device));
    std::memcpy(mine.device.data(), about.uuid.bytes, sizeof(mine.device));
    ncclUniqueId meeting{};
    static_assert(sizeof(meeting.internal) == sizeof(mine.meeting));
    if (!is_first) return mine;
    const ncclResult_t found = ncclGetUniqueId(&meeting);
    if (found != ncclSuccess) throw RunError(std::string("ncclGetUniqueId: ") + ncclGetErrorString(found));
    std::memcpy(mine.meeting.data(), meeting.internal, sizeof(mine.meeting));
    return mine;
  }

  std::unique_ptr<DeviceLink> link(const LinkPart& first, Ranks& ranks, void* queue) override {
    ncclUniqueId meeting{};
    std::memcpy(meeting.internal, first.meeting.data(), sizeof(meeting.internal));
    return std::make_unique<NcclLink>(meeting, ranks.rank(), ranks.size(), static_cast<cudaStream_t>(queue));
  }
};

}  // namespace
}  // namespace thalweg

/// The one symbol of the module.
extern "C" __attribute__((visibility("default"))) thalweg::LinkMaker* thalweg_nccl_links() {
  static thalweg::NcclLinks links;
  return &links;
}
