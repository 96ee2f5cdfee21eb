#pragma once

#include <utility>

#include "case/reader/mistakes.hpp"
#include "case/reader/table_reader.hpp"

namespace thalweg {

/// Visits the struct of a table as TableReader does, and goes on after a mistake. A key with a mistake keeps its default.
class LenientReader {
 public:
  LenientReader(TableReader reader, Mistakes& mistakes) : reader_(std::move(reader)), mistakes_(mistakes) {}

  template <class... A>
  void quantity(A&&... a) {
    mistakes_.attempt([&] { reader_.quantity(std::forward<A>(a)...); });
  }
  template <class... A>
  void number(A&&... a) {
    mistakes_.attempt([&] { reader_.number(std::forward<A>(a)...); });
  }
  template <class... A>
  void integer(A&&... a) {
    mistakes_.attempt([&] { reader_.integer(std::forward<A>(a)...); });
  }
  template <class... A>
  void flag(A&&... a) {
    mistakes_.attempt([&] { reader_.flag(std::forward<A>(a)...); });
  }
  template <class... A>
  void text(A&&... a) {
    mistakes_.attempt([&] { reader_.text(std::forward<A>(a)...); });
  }
  template <class... A>
  void texts(A&&... a) {
    mistakes_.attempt([&] { reader_.texts(std::forward<A>(a)...); });
  }
  template <class... A>
  void point(A&&... a) {
    mistakes_.attempt([&] { reader_.point(std::forward<A>(a)...); });
  }
  template <class... A>
  void direction(A&&... a) {
    mistakes_.attempt([&] { reader_.direction(std::forward<A>(a)...); });
  }
  template <class... A>
  void quantities(A&&... a) {
    mistakes_.attempt([&] { reader_.quantities(std::forward<A>(a)...); });
  }
  template <class... A>
  void polygon(A&&... a) {
    mistakes_.attempt([&] { reader_.polygon(std::forward<A>(a)...); });
  }
  template <class... A>
  void choice(A&&... a) {
    mistakes_.attempt([&] { reader_.choice(std::forward<A>(a)...); });
  }

 private:
  TableReader reader_;
  Mistakes& mistakes_;
};

}  // namespace thalweg
