// SPDX-License-Identifier: Apache-2.0
// Binds the class that Verilator printed to Model. Compiled once a model; ports.inc is printed by verilate.py:
// HS_PORT(name, bits, is_input) a port, HS_WATCH(stream, path, bits) a stream inside (watch.vlt), HS_CONSTANT(name,
// value) a number of the package; title.inc says what the model is.
#include <verilated.h>

#include <cstdlib>
#include <string>

#include "Vmodel.h"
#include "Vmodel___024root.h"
#if __has_include("Vmodel_hs_mutant.h")
#include "Vmodel_hs_mutant.h"
#endif
#include "tb/harness/model.hpp"
#include "title.inc"
#ifdef HS_TRACED
#include <verilated_fst_c.h>
#endif

double sc_time_stamp() { return 0; }

namespace halfspace::tb {
namespace {

class Binding final : public Model {
 public:
  Binding(std::uint64_t seed, Start start) : Model(HS_TOP, HS_CONFIG, HS_LANES_X, HS_LANES_Y) {
#ifdef HS_TRACED
    context_.traceEverOn(true);
#endif
    context_.randReset(int(start));
    context_.randSeed(int(seed & 0x7fffffff) | 1);
    top_ = std::make_unique<Vmodel>(&context_);
#define HS_PORT(name, bits, is_input) add_port(#name, &top_->name, int(sizeof top_->name), bits, is_input);
#define HS_WATCH(stream, path, bits)                                                         \
  add_watch(#stream, &top_->rootp->path##__DOT__valid_i, &top_->rootp->path##__DOT__ready_i, \
            &top_->rootp->path##__DOT__word_i, int(sizeof top_->rootp->path##__DOT__word_i), bits);
#define HS_CONSTANT(name, value) add_constant(#name, value);
#define HS_VARIABLE(name, path) add_port(#name, &top_->path, int(sizeof top_->path), 32, true);
#include "ports.inc"
#undef HS_VARIABLE
#undef HS_CONSTANT
#undef HS_WATCH
#undef HS_PORT
#ifdef HS_TRACED
    if (has_wave()) open_wave();
#endif
  }
  ~Binding() override {
    // Verilator takes the model out of the context that was made last, which may be gone.
    Verilated::threadContextp(&context_);
    top_->final();
#ifdef VERILATOR_VERILATED_COV_H_
    // tb/coverage.py: what was reached goes to a file for each model.
    if (const char* const file = std::getenv("HALFSPACE_COVERAGE"))
      context_.coveragep()->write((file + std::to_string(number()) + ".dat").c_str());
#endif
#ifdef HS_TRACED
    if (wave_) wave_->close();
#endif
  }
  void eval() override { top_->eval_step(); }

 private:
#ifdef HS_TRACED
  void open_wave() {
    wave_ = std::make_unique<VerilatedFstC>();
    top_->trace(wave_.get(), 99);
    wave_->set_time_unit("1ns");
    wave_->set_time_resolution("1ns");
    wave_->open(wave.file.c_str());
  }
  void write_wave(std::uint64_t nanoseconds) override { wave_->dump(nanoseconds); }
#else
  void write_wave(std::uint64_t) override {}
#endif

  VerilatedContext context_;
  std::unique_ptr<Vmodel> top_;
#ifdef HS_TRACED
  std::unique_ptr<VerilatedFstC> wave_;
#endif
};

}  // namespace

std::unique_ptr<Model> make_model(std::uint64_t seed, Start start) { return std::make_unique<Binding>(seed, start); }

std::string model_top() { return HS_TOP; }

TracedBuild traced_build() {
#ifdef HS_TRACED
  return {true, {}};
#else
  return {false, {HS_TRACED_BUILD}};
#endif
}

}  // namespace halfspace::tb
