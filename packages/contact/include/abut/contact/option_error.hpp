// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"

#include <string>

namespace abut::contact {

/// What is wrong with the options of an interface: "PATH: REASON", where the path is that of the
/// key, contact.NAME.KEY. A host that knows where the user gave the key says it in front.
class OptionError : public InputError {
public:
  OptionError(const std::string& path, const std::string& reason)
      : InputError(path + ": " + reason), path_(path), reason_(reason) {}

  const std::string& path() const { return path_; }
  const std::string& reason() const { return reason_; }

private:
  std::string path_, reason_;
};

} // namespace abut::contact
