// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/plan.hpp"

#include <cstring>
#include <set>

namespace halfspace::tb {
namespace {

// Whose words are in a memory that the unit only reads, or that it finds full: no port tells.
struct Filled {
  const char *unit, *stream;
};
const Filled kFilled[] = {{"scan_index", "update"},
                          {"shade_gouraud", "planes"},
                          {"shade_phong", "planes"},
                          {"shade_texture", "texture_planes"},
                          {"motion_field", "motion_planes"}};

// Where a stage stands between two units, its stream goes into the port that the other one's goes into where there is
// none: `triangle` behind index_pool, `attributes` behind visible_select, `pixel` before shade_texture.
std::string port_of(const Model& model, const Vectors& vectors, const std::string& stream, const char* between,
                    const char* without) {
  if (!vectors.find(between) || model.find(std::string(between) + "_valid_o")) return stream;
  return stream == between ? without : stream == without ? "" : stream;
}

// Whether the unit has the ports of a stream that its configuration does not have.
bool is_idle(const Model& model, const std::string& stream) {
  if (stream == "triangle_depth") return !model.constant("HasDepth") || model.constant("StoresDepth");
  return stream == "colours" && !model.constant("Lights");
}

// Every port has to be known, or the bench would look away.
class Known {
 public:
  void add(const std::string& name) { names_.insert(name); }
  void add_input(const std::string& stream) {
    for (const char* const end : {"_valid_i", "_ready_o", "_i"}) add(stream + end);
  }
  void add_output(const std::string& stream) {
    for (const char* const end : {"_valid_o", "_ready_i", "_o"}) add(stream + end);
  }
  void add_memory(const MemoryPorts& ports) {
    for (const char* const name : {ports.read_data, ports.read_enable, ports.read_bank, ports.read_address,
                                   ports.write_enable, ports.write_bank, ports.write_address, ports.write_data}) {
      if (name) add(name);
    }
  }
  void check(const Model& model, const Vectors& vectors) const {
    for (const auto& [name, port] : model.ports()) {
      if (names_.count(name)) continue;
      if (const std::size_t end = name.rfind("_valid_"); end != std::string::npos) {
        need_stream(vectors, name.substr(0, end));
      }
      throw Error(model.title() + ": nothing is known of port " + name + "; tell tb/harness/plan.cpp");
    }
  }

 private:
  // The clock, and what each unit calls alike; tokens of scan_index are made by its bench.
  std::set<std::string> names_{"clk_i",         "rst_ni",        "frame_width_i", "frame_height_i", "background_i",
                               "start_valid_i", "start_ready_o", "start_clear_i", kNoneLeft};
};

}  // namespace

std::string unit_of(const Model& model) { return model.top().substr(std::strlen("hs_")); }

const Stream& need_stream(const Vectors& vectors, const std::string& name) {
  if (const Stream* const stream = vectors.find(name)) return *stream;
  throw Error(vectors.directory + "/manifest.json: has no stream " + name +
              ", which the bench needs; make the set again");
}

Plan plan_of(const Model& model, const Vectors& vectors) {
  Plan plan;
  Known known;
  for (const char* const stream : {"triangle_depth", "colours"}) {
    if (!is_idle(model, stream)) continue;
    known.add_input(stream);
    known.add_output(stream);
  }
  for (const MemoryPorts* const ports : kMemories) {
    if (Memory::fits(model, *ports)) known.add_memory(*ports);
  }
  for (const Stream& stream : vectors.streams) {
    std::string in = port_of(model, vectors, stream.name, "visible_attributes", "attributes");
    if (in == stream.name) in = port_of(model, vectors, in, "numbered", "triangle");
    if (model.find(in + "_valid_i")) {
      (model.find(in + "_ready_o") ? plan.takes : plan.loads).push_back({&stream, in});
      known.add_input(in);
    } else if (model.find(in + "_i")) {
      plan.registers.push_back({&stream, in});
      known.add(in + "_i");
    }
    const std::string out =
        model.find("lit_valid_i") ? stream.name : port_of(model, vectors, stream.name, "lit", "pixel");
    if (model.find(out + "_valid_o")) {
      plan.sends.push_back({&stream, out});
      known.add_output(out);
    }
  }
  for (const Filled& filled : kFilled) {
    if (filled.unit == unit_of(model)) plan.fills = &need_stream(vectors, filled.stream);
  }
  known.check(model, vectors);
  return plan;
}

}  // namespace halfspace::tb
