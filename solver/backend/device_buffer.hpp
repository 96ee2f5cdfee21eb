#pragma once

#include <cstddef>
#include <utility>

namespace thalweg {

/// An array in the memory of a device. Contents are kept when it grows; new entries are uninitialised.
template <class T, class Runtime>
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;
  DeviceBuffer(DeviceBuffer&& b) noexcept { swap(b); }
  DeviceBuffer& operator=(DeviceBuffer&& b) noexcept {
    swap(b);
    return *this;
  }
  ~DeviceBuffer() { Runtime::release(data_); }

  void resize(std::size_t n) {
    if (n > capacity_) {
      DeviceBuffer larger;
      larger.data_ = static_cast<T*>(Runtime::allocate(n * sizeof(T)));
      larger.capacity_ = n;
      if (size_ > 0) Runtime::copy_on_device(larger.data_, data_, size_ * sizeof(T));
      swap(larger);
    }
    size_ = n;
  }
  /// The same without the contents. The old memory is given back before more is asked for, a sixteenth more than is needed,
  /// so that a buffer that grows a little now and then seldom moves.
  void resize_anew(std::size_t n) {
    if (n > capacity_) {
      DeviceBuffer().swap(*this);
      const std::size_t room = n + n / 16;
      data_ = static_cast<T*>(Runtime::allocate(room * sizeof(T)));
      capacity_ = room;
    }
    size_ = n;
  }
  void shrink_to_fit() {
    if (capacity_ == size_) return;
    DeviceBuffer smaller;
    smaller.resize(size_);
    if (size_ > 0) Runtime::copy_on_device(smaller.data_, data_, size_ * sizeof(T));
    swap(smaller);
  }
  void swap(DeviceBuffer& b) noexcept {
    std::swap(data_, b.data_);
    std::swap(size_, b.size_);
    std::swap(capacity_, b.capacity_);
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// The bytes of a message between ranks, where the device writes and reads them: in page-locked memory of the host, or in the
/// device's own for ranks that take them from there. Contents are lost when it grows.
template <class Runtime>
class MessageBytes {
 public:
  MessageBytes() = default;
  explicit MessageBytes(bool on_device) : on_device_(on_device) {}
  MessageBytes(const MessageBytes&) = delete;
  MessageBytes& operator=(const MessageBytes&) = delete;
  MessageBytes(MessageBytes&& b) noexcept { swap(b); }
  MessageBytes& operator=(MessageBytes&& b) noexcept {
    swap(b);
    return *this;
  }
  ~MessageBytes() {
    if (on_device_) {
      Runtime::release_message(data_);
    } else {
      Runtime::release_on_host(data_);
    }
  }

  void resize(std::size_t n) {
    if (n > capacity_) {
      if (data_ != nullptr) Runtime::wait();  // the device may still read it
      MessageBytes(on_device_).swap(*this);
      const std::size_t room = n + n / 4;
      data_ = static_cast<std::byte*>(on_device_ ? Runtime::allocate_message(room) : Runtime::allocate_on_host(room));
      capacity_ = room;
    }
    size_ = n;
  }
  void swap(MessageBytes& b) noexcept {
    std::swap(data_, b.data_);
    std::swap(size_, b.size_);
    std::swap(capacity_, b.capacity_);
    std::swap(on_device_, b.on_device_);
  }

  [[nodiscard]] std::byte* data() { return data_; }
  [[nodiscard]] const std::byte* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  bool on_device_ = false;
};

}  // namespace thalweg
