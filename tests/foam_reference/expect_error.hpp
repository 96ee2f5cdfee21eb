#pragma once

#include <gtest/gtest.h>

#include <string>

namespace thalweg::foam {

/// The message of the `Error` that `action` throws; a test failure when it throws none.
template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

}  // namespace thalweg::foam
