#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/particle_frame.hpp"
#include "common/io/xml_tree.hpp"
#include "common/particle_source.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// A particle file as our programs write it, of which ranges are read: neither its text nor its other particles are in memory.
class RangedParticleReader final : public ParticleSource {
 public:
  /// Nothing for a file without a seal, or in another encoding, which has to be read at once. Throws InputError if it cannot be
  /// read, or if its seal is broken.
  static std::optional<RangedParticleReader> open(const std::filesystem::path& file);

  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] const ParticleSet& frame() const override { return frame_.set; }
  /// Of the field data, by name.
  [[nodiscard]] const std::map<std::string, std::string>& texts() const { return frame_.texts; }
  /// Throws InputError "file: what is wrong; what to do".
  ParticleSet range(std::uint64_t from, std::uint64_t to) override;

 private:
  /// An array of particles in the file.
  struct Array {
    std::string type;                   // VTK's word
    std::size_t components = 1;         // numbers of a particle
    std::size_t bytes = 0;              // of a particle
    std::streamoff text = 0;            // where the base64 of its blocks begins
    std::vector<std::uint64_t> blocks;  // where they begin in the decoded bytes, and the end of the last
  };

  explicit RangedParticleReader(const std::filesystem::path& file);
  [[nodiscard]] bool find_arrays();
  [[nodiscard]] bool add_array(const XmlElement& element, const std::string& name);
  [[nodiscard]] bool has_types() const;
  void read_frame(const XmlElement& piece);
  [[nodiscard]] std::string decoded(std::streamoff text, std::uint64_t from, std::uint64_t to);
  void read_bytes(const Array& array, std::uint64_t from, std::uint64_t to, char* into);
  template <class T>
  void read(const std::string& name, std::uint64_t from, std::uint64_t to, std::vector<T>& into);
  void read_positions(std::uint64_t from, std::uint64_t to, std::vector<Vec3>& into);
  void check(std::uint64_t from, const ParticleSet& particles) const;
  [[noreturn]] void reject(const std::string& what, const std::string& cure) const;

  std::filesystem::path file_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  ParticleFrame frame_;
  std::map<std::string, Array> arrays_;
};

}  // namespace thalweg
