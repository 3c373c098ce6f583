// SPDX-License-Identifier: Apache-2.0
// Binds the class that Verilator printed to Model. Compiled once a model; ports.inc is printed by verilate.py:
// HS_PORT(name, bits, is_input) a port, HS_WATCH(stream, path, bits) a stream inside (watch.vlt), HS_CONSTANT(name,
// value) a number of the package; title.inc says what the model is.
#include <verilated.h>

#include "Vmodel.h"
#include "Vmodel___024root.h"
#include "tb/harness/model.hpp"
#include "title.inc"

double sc_time_stamp() { return 0; }

namespace halfspace::tb {
namespace {

class Binding final : public Model {
 public:
  Binding(std::uint64_t seed, Start start) : Model(HS_TOP, HS_CONFIG, HS_LANES_X, HS_LANES_Y) {
    context_.randReset(int(start));
    context_.randSeed(int(seed & 0x7fffffff) | 1);
    top_ = std::make_unique<Vmodel>(&context_);
#define HS_PORT(name, bits, is_input) add_port(#name, &top_->name, int(sizeof top_->name), bits, is_input);
#define HS_WATCH(stream, path, bits)                                                         \
  add_watch(#stream, &top_->rootp->path##__DOT__valid_i, &top_->rootp->path##__DOT__ready_i, \
            &top_->rootp->path##__DOT__word_i, int(sizeof top_->rootp->path##__DOT__word_i), bits);
#define HS_CONSTANT(name, value) add_constant(#name, value);
#include "ports.inc"
#undef HS_CONSTANT
#undef HS_WATCH
#undef HS_PORT
  }
  ~Binding() override { top_->final(); }
  void eval() override { top_->eval_step(); }

 private:
  VerilatedContext context_;
  std::unique_ptr<Vmodel> top_;
};

}  // namespace

std::unique_ptr<Model> make_model(std::uint64_t seed, Start start) { return std::make_unique<Binding>(seed, start); }

std::string model_top() { return HS_TOP; }

}  // namespace halfspace::tb
