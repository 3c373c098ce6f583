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
const Filled kKept[] = {{"hole_scan", "between"}, {"film_scan", "between"}, {"film_scan", "shown"}};

// Where a stage stands between two units, its stream goes into the port that the other one's goes into where there is
// none: `triangle` behind index_pool, `attributes` behind visible_select, `scan` behind hole_scan, `pixel` before
// shade_texture.
std::string port_of(const Model& model, const Vectors& vectors, const std::string& stream, const char* between,
                    const char* without) {
  const std::string name = between;
  if (!vectors.find(name) || model.find(name + "_valid_o") || model.find(name + "_valid_i")) return stream;
  return stream == name ? without : stream == without ? "" : stream;
}

// The port that a unit takes a stream at.
std::string input_of(const Model& model, const Vectors& vectors, std::string stream) {
  stream = port_of(model, vectors, stream, "visible_attributes", "attributes");
  stream = port_of(model, vectors, stream, "numbered", "triangle");
  stream = port_of(model, vectors, stream, "masked", "scan");
  return port_of(model, vectors, stream, "ordered", "motion");
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
  // The clock, and what each unit calls alike; tokens of scan_index and film_scan are made by their bench.
  std::set<std::string> names_{"mutant_i",     "clk_i",         "rst_ni",        "frame_width_i", "frame_height_i",
                               "background_i", "start_valid_i", "start_ready_o", "start_clear_i", "show_valid_i",
                               "show_ready_o", "show_i",        "fill_i",        kNoneLeft};
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
    for (const char* const end : {"_valid_o", "_o", "_ready_o"}) {
      if (const Port* const port = model.find(stream + std::string(end))) plan.zeros.push_back(port);
    }
  }
  for (const MemoryPorts* const ports : kMemories) {
    if (Memory::fits(model, *ports)) known.add_memory(*ports);
  }
  for (const Stream& stream : vectors.streams) {
    const std::string in = input_of(model, vectors, stream.name);
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
  for (const Filled& kept : kKept) {
    if (kept.unit == unit_of(model)) plan.keeps.push_back(&need_stream(vectors, kept.stream));
  }
  if (vectors.is_film()) known.add("key_weight_i");
  known.check(model, vectors);
  return plan;
}

}  // namespace halfspace::tb
