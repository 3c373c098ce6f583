// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/model.hpp"

#include <cstring>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

const Port* Model::find(const std::string& name) const {
  const auto found = ports_.find(name);
  return found == ports_.end() ? nullptr : &found->second;
}

const Port& Model::need(const std::string& name, int bits) const {
  const Port* const port = find(name);
  if (port == nullptr) {
    throw Error(title() + ": the model has no port " + name +
                ", and no hs_stream inside has this name; bring the RTL and docs/architecture.md together");
  }
  if (bits != 0 && port->bits != bits) {
    throw Error(title() + ": port " + name + " has " + std::to_string(port->bits) + " bits where the vectors have " +
                std::to_string(bits) + "; print the package (`halfspace package`), build the model and make the " +
                "vectors from the same formats");
  }
  return *port;
}

void Model::add_port(const std::string& name, void* data, int bytes, int bits, bool input) {
  if (input) std::memset(data, 0, std::size_t(bytes));
  ports_[name] = Port{name, data, bytes, bits, input};
}

void Model::add_watch(const std::string& stream, void* valid, void* ready, void* word, int bytes, int bits) {
  add_port(stream + "_valid_o", valid, 1, 1, false);
  add_port(stream + "_ready_o", ready, 1, 1, false);
  add_port(stream + "_o", word, bytes, bits, false);
}

int Model::constant(const std::string& name) const {
  const auto found = constants_.find(name);
  return found == constants_.end() ? 0 : found->second;
}

void Model::set(const std::string& name, std::uint64_t value) {
  const Port& port = need(name);
  std::memset(port.data, 0, std::size_t(port.bytes));
  std::memcpy(port.data, &value, std::size_t(port.bytes < 8 ? port.bytes : 8));
}

std::string Model::title() const {
  return top_ + " (" + config_ + ", " + std::to_string(lanes_x_) + "x" + std::to_string(lanes_y_) + " lanes)";
}

}  // namespace halfspace::tb
