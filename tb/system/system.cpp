// SPDX-License-Identifier: Apache-2.0
#include "tb/system/system.hpp"

#include <cstdio>

#include "tb/harness/pipeline.hpp"
#include "tb/system/memory.hpp"
#include "tb/system/scene.hpp"

namespace halfspace::tb {
namespace {

// Where the piece of memory begins that the driver gives out: triangles of a small frame cross 4 KiB.
constexpr std::uint32_t kBase = 0x10f40;
constexpr std::size_t kBytes = std::size_t(1) << 28;
constexpr std::uint32_t kDirty = 1u << 22;
constexpr std::uint32_t kIndexBase = 0x0c000000, kDepthBase = 0x0d000000, kPlanesBase = 0x0e000000;

constexpr std::uint32_t kNoRegister = 0xfc;

// hs_system with a memory, a processor and a screen around it, for one Bench.
struct Board {
  Bench bench;
  AxiMemory memory;
  RegisterPort registers;
  VideoPort video;
  hs_device device = {};

  Board(Model* model, const Vectors& vectors, const Options& options, Bytes* bytes)
      : bench(model, &vectors, &options, "system"),
        memory(*model, bytes,
               {options.latency < 0 ? 40 : options.latency, options.stall, options.refresh, options.seed}),
        registers(*model, options.seed, options.stall, [this] { bench.idle(1); }),
        video(*model, options.seed, options.stall) {
    bench.add_partner(&memory);
    bench.add_partner(&registers);
    bench.add_partner(&video);
  }

  void open(const Vectors& vectors) {
    const hs_bus bus = {[](void* board, std::uint32_t at) { return static_cast<Board*>(board)->registers.read(at); },
                        [](void* board, std::uint32_t at, std::uint32_t value) {
                          static_cast<Board*>(board)->registers.write(at, value);
                        },
                        this};
    if (const char* const wrong = hs_open(&device, bus)) bench.fail(std::string("driver: ") + wrong);
    if (int(device.lanes_x) != vectors.lanes_x || int(device.lanes_y) != vectors.lanes_y) {
      bench.fail("registers: the lanes are not those of the model");
    }
    registers.read(kNoRegister);
    if (!registers.refused()) bench.fail("registers: a read where there is none is not refused");
    registers.write(HS_ID, 0);
    if (!registers.refused()) bench.fail("registers: a write of one that is read alone is not refused");
    hs_set_buffers(&device, kIndexBase, kDepthBase, kPlanesBase);
    hs_enable_interrupts(
        &device, HS_INTERRUPT_ENABLE_DONE_MASK | HS_INTERRUPT_ENABLE_STOPPED_MASK | HS_INTERRUPT_ENABLE_ERROR_MASK);
  }

  bool interrupt() const { return is_set(interrupt_); }

 private:
  const Port& interrupt_ = bench.model().need("interrupt_o", 1);
};

using List = std::vector<std::size_t>;  // frames, one after the other

// The command list of these, in memory.
hs_list list_of(const Vectors& vectors, const hs_device& device, hs_memory* memory, const List& frames) {
  constexpr std::pair<const char*, hs_kind> kLoads[] = {
      {"light", HS_LIGHT}, {"material", HS_MATERIAL}, {"texture", HS_TEXTURE}, {"texel", HS_TEXEL}};
  hs_list list;
  memory->used = 0;
  hs_list_begin(&list, memory, 8 + 5 * frames.size());
  const std::size_t first = frames.front();
  for (const auto& [name, kind] : kLoads) {
    const Stream* const stream = vectors.find(name);
    if (stream == nullptr || stream->frame_words[first] == 0) continue;
    std::vector<std::uint8_t> widths;
    const std::vector<std::uint64_t> values = values_of(*stream, first, &widths);
    const std::size_t count = stream->frame_words[first];
    hs_list_load(&list, kind, hs_put_records(memory, values.data(), widths.data(), widths.size(), count),
                 std::uint32_t(count));
  }
  for (const std::size_t frame : frames) {
    const std::vector<hs_triangle> triangles = triangles_of(vectors, frame);
    if (device.answer_words != 0) {
      const std::vector<hs_answer> answers = answers_of(vectors, frame);
      hs_list_answers(&list, hs_put_answers(&device, memory, answers.data(), answers.size()));
    }
    // Two pieces, to have commands in the midst of a frame.
    const std::size_t half = triangles.size() / 2;
    const std::uint32_t at = hs_put_triangles(&device, memory, triangles.data(), half);
    const std::uint32_t then = hs_put_triangles(&device, memory, triangles.data() + half, triangles.size() - half);
    hs_list_draw(&list, at, std::uint32_t(half), 0);
    if (frame % 2 == 1) hs_list_wait_tested(&list);
    hs_list_draw(&list, then, std::uint32_t(triangles.size() - half), 1);
    if (frame % 4 == 3) hs_list_wait_out(&list);
  }
  hs_list_end(&list);
  return list;
}

void start(Board* board, const Vectors& vectors, hs_memory* memory, const List& frames) {
  const Frame& frame = vectors.frames[frames.front()];
  const hs_list list = list_of(vectors, board->device, memory, frames);
  hs_set_frame(&board->device, frame.width, frame.height, frame.background[0], frame.background[1],
               frame.background[2]);
  if (!hs_start(&board->device, &list)) board->bench.fail("driver: the list does not fit into the memory");
}

// After a reset the pipeline clears both banks of its I-buffer before the first triangle.
std::uint64_t patience_of(const Model& model, const Options& options) {
  const int stamps = model.constant("MaxWidth") * model.constant("MaxHeight") / (model.lanes_x() * model.lanes_y());
  return options.hang + 3 * std::uint64_t(stamps);
}

bool is_in_trouble(const Options& options) {
  return options.stop_at != 0 || options.reset_at != 0 || options.break_read != 0 || options.break_write != 0;
}

// The first list is given up in one way, and the state behind it is as it has to be.
void run_trouble(Model* model, const Vectors& vectors, const Options& options, Bytes* bytes, const List& frames,
                 Result* result) {
  Board board(model, vectors, options, bytes);
  board.bench.reset();
  board.open(vectors);
  board.video.give_up();
  hs_memory memory = {bytes->data() + kBase, kBase, kIndexBase - kBase, 0};
  board.memory.break_read(options.break_read);
  board.memory.break_write(options.break_write);
  start(&board, vectors, &memory, frames);
  if (options.stop_at != 0) {
    board.bench.idle(int(options.stop_at));
    if (!board.interrupt()) hs_stop(&board.device);
  }
  if (options.reset_at != 0) {
    board.bench.idle(int(options.reset_at));
  } else {
    if (!board.bench.run([&] { return board.interrupt(); }, patience_of(*model, options))) {
      board.bench.fail("trouble: no interrupt comes");
    }
    for (int n = 0; n < 1000 && hs_busy(&board.device); ++n) board.bench.idle(10);
    if (!board.memory.idle()) board.bench.fail("trouble: a transfer is under way, and it is not busy");
    const hs_state state = hs_status(&board.device);
    const std::uint32_t happened = hs_happened(&board.device);
    const bool stops = options.stop_at != 0;
    const std::uint32_t mask = stops ? HS_INTERRUPT_PENDING_STOPPED_MASK : HS_INTERRUPT_PENDING_ERROR_MASK;
    if (state.busy) board.bench.fail("trouble: it is busy for ever");
    if (state.done || (stops ? !state.stopped : !state.error) || (happened & mask) == 0) {
      board.bench.fail("trouble: the status does not say that the frame was given up");
    }
    if (!stops && state.error_kind != (options.break_read != 0 ? 1u : 2u)) {
      board.bench.fail("trouble: the status says another kind of error");
    }
    board.bench.idle(1);
    if (board.interrupt()) board.bench.fail("trouble: the interrupt stays");
  }
  board.bench.abandon(" (given up)", result);
  std::printf("given up: after %llu cycles\n", static_cast<unsigned long long>(board.bench.cycle()));
}

}  // namespace

std::string system_report(const hs_counters& counters, const Vectors& vectors) {
  static const char* const kReads[] = {"index", "depth", "scan", "planes", "commands", "answers"};
  static const char* const kWrites[] = {"index", "depth", "planes"};
  char line[200];
  std::string text;
  const auto add = [&](const char* what, std::uint32_t value) {
    if (value == 0) return;
    std::snprintf(line, sizeof line, "  %-28s %12u %12u\n", what, value, value / std::max(counters.frames, 1u));
    text += line;
  };
  std::snprintf(line, sizeof line, "%s %s, the last list: %u frames, %u triangles, %u visible\n", vectors.scene.c_str(),
                vectors.config.c_str(), counters.frames, counters.drawn, counters.visible);
  text += line;
  text += "                                        all      a frame\n";
  add("cycles", counters.cycles);
  add("waits for triangles", counters.triangle_waits);
  add("waits of video", counters.video_waits);
  for (int i = 0; i < 6; ++i) add((std::string("bytes read, ") + kReads[i]).c_str(), counters.read[i]);
  for (int i = 0; i < 3; ++i) add((std::string("bytes written, ") + kWrites[i]).c_str(), counters.written[i]);
  return text;
}

Result run_system(Model* model, const Vectors& vectors, const Options& options, Picture* last) {
  if (vectors.window != 0 || vectors.find("pixel") == nullptr) {
    throw Error(vectors.directory +
                "/manifest.json: hs_system takes a set with pixels, of triangles that are not held "
                "back");
  }
  // Frames that follow each other: lists. The last frame is drawn several times.
  std::vector<List> lists;
  std::size_t left_out = 0, before = 0;
  for (std::size_t frame = 0; frame < vectors.frames.size(); ++frame) {
    if (!is_in_order(vectors, frame)) {
      ++left_out;
      continue;
    }
    if (lists.empty() || before + 1 != frame || !may_follow(vectors, before, frame)) lists.emplace_back();
    lists.back().push_back(frame);
    before = frame;
  }
  if (lists.empty()) throw Error(vectors.directory + "/triangle.hex: no frame has the places of triangles as indices");
  if (left_out != 0) std::printf("%zu frames are left out: the indices of their triangles are no places\n", left_out);
  lists.back().insert(lists.back().end(), std::size_t(options.frames - 1), lists.back().back());

  Bytes bytes(kBytes);
  // Buffers of the frame begin with anything.
  Random random(options.seed);
  for (const std::uint32_t base : {kIndexBase, kDepthBase, kPlanesBase}) {
    for (std::uint32_t at = 0; at < kDirty; ++at) bytes[base + at] = std::uint8_t(random.next());
  }
  Result result;
  result.unit = "system";
  const Stopwatch stopwatch;
  if (is_in_trouble(options)) {
    run_trouble(model, vectors, options, &bytes, lists.front(), &result);
  }
  Board board(model, vectors, options, &bytes);
  std::vector<std::pair<const Stream*, Receiver*>> receivers;
  for (const Stream& stream : vectors.streams) {
    if (model->find(stream.name + "_valid_o") == nullptr) continue;
    receivers.emplace_back(&stream, &board.bench.add_receiver(stream));
  }
  if (!is_in_trouble(options) || options.reset_at != 0) board.bench.reset();
  board.open(vectors);
  if (is_in_trouble(options) && options.reset_at == 0) board.video.give_up();
  hs_memory memory = {bytes.data() + kBase, kBase, kIndexBase - kBase, 0};
  hs_counters counters = {};
  for (const List& list : lists) {
    for (const std::size_t frame : list) {
      for (const auto& [stream, receiver] : receivers) receiver->expect(segment_of(*stream, frame));
      board.video.expect(picture_of(vectors, frame));
    }
    start(&board, vectors, &memory, list);
    if (!board.bench.run([&] { return board.interrupt(); }, patience_of(*model, options))) break;
    const hs_state state = hs_status(&board.device);
    if (!state.done || state.busy || state.error || state.stopped) {
      board.bench.fail("status: the list ended, and it does not say that it is done and that nothing was wrong");
    }
    hs_happened(&board.device);
    counters = hs_count(&board.device);
    std::size_t drawn = 0;
    for (const std::size_t frame : list) {
      drawn += std::max<std::size_t>(triangles_of(vectors, frame).size(), 1);
    }
    if (counters.frames != list.size() || counters.drawn != drawn) {
      board.bench.fail("counters: frames or triangles are not those of the list");
    }
    if (!board.memory.idle()) board.bench.fail("bus: a transfer is under way when the list is done");
    if (!board.video.done()) board.bench.fail("video: the list is done and a frame has not come");
  }
  board.bench.idle(64);
  board.bench.finish(&result);
  stopwatch.stop(&result);
  const std::vector<std::uint64_t>& ends = board.video.ends();
  result.frame_ends = ends;
  if (options.frames > 1 && ends.size() > 1) {
    result.cycles = ends.back() - ends[ends.size() - 2];
    result.cycles_of = "the last frame, in steady state";
  } else {
    result.cycles = counters.cycles;
    result.cycles_of = "the last list";
  }
  *last = board.video.last();
  if (!options.only_wave) std::printf("%s", system_report(counters, vectors).c_str());
  return result;
}

}  // namespace halfspace::tb
