#pragma once

#include "case/check_context.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// [tracer]: a number that particles carry along and that nothing feels; the template for a table of a new model.
struct TracerTable {
  static constexpr TableHeading heading{"tracer", "A number that particles carry along."};

  bool on = false;
  double start = 0;  // [s]

  template <class V>
  void describe(V& v) {
    v.flag("on", on, "True: particles carry the tracer, the time for which they have moved.");
    v.quantity("start", start, "s", 0, 1e9, "Value of the tracer at the start.");
  }

  void check(const Case&, const CheckContext& at) const {
    if (!on && start != 0) at.reject(at.key("start"), "tracer.start means nothing without a tracer", "write on = true");
  }
};

}  // namespace thalweg
