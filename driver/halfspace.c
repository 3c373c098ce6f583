/* SPDX-License-Identifier: Apache-2.0 */
#include "driver/halfspace.h"

/* Commands, hs_commands.sv. */
enum { kEnd = 0, kDraw = 1, kWait = 2, kLoad = 3, kAnswers = 4 };

static uint32_t get(const hs_device* device, uint32_t offset) { return device->bus.read(device->bus.context, offset); }

static void set(const hs_device* device, uint32_t offset, uint32_t value) {
  device->bus.write(device->bus.context, offset, value);
}

#define FIELD(value, name) (((value)&name##_MASK) >> name##_LSB)

static uint32_t words_of(uint32_t bits) { return (bits + 63) / 64; }

const char* hs_open(hs_device* device, hs_bus bus) {
  uint32_t value;
  device->bus = bus;
  if (get(device, HS_ID) != 0x68733031u) return "there is no hs_system at this address";
  value = get(device, HS_BUS);
  if (FIELD(value, HS_BUS_VERSION) != 1) return "this hs_system has registers of another version";
  device->bus_bytes = FIELD(value, HS_BUS_BYTES);
  value = get(device, HS_LANES);
  device->lanes_x = FIELD(value, HS_LANES_X);
  device->lanes_y = FIELD(value, HS_LANES_Y);
  value = get(device, HS_LARGEST);
  device->width = FIELD(value, HS_LARGEST_WIDTH);
  device->height = FIELD(value, HS_LARGEST_HEIGHT);
  device->triangles = get(device, HS_TRIANGLES);
  value = get(device, HS_WIDTHS);
  device->coord_bits = FIELD(value, HS_WIDTHS_COORD);
  device->subpixel_bits = FIELD(value, HS_WIDTHS_SUBPIXEL);
  device->depth_bits = FIELD(value, HS_WIDTHS_DEPTH);
  device->colour_bits = FIELD(value, HS_WIDTHS_COLOUR);
  value = get(device, HS_FEATURES);
  device->colours = FIELD(value, HS_FEATURES_COLOURS);
  device->normals = FIELD(value, HS_FEATURES_NORMALS);
  device->coordinates = FIELD(value, HS_FEATURES_COORDINATES);
  device->outside_frame = FIELD(value, HS_FEATURES_OUTSIDE_FRAME);
  device->outside_planes = FIELD(value, HS_FEATURES_OUTSIDE_PLANES);
  value = get(device, HS_ANSWERS);
  device->normal_bits = FIELD(value, HS_ANSWERS_NORMAL);
  device->material_bits = FIELD(value, HS_ANSWERS_MATERIAL);
  device->texture_bits = FIELD(value, HS_ANSWERS_TEXTURE);
  device->repeat_bits = FIELD(value, HS_ANSWERS_REPEATS);
  device->coordinate_bits = get(device, HS_COORDINATE);
  device->triangle_words =
      words_of(6 * device->coord_bits + 3 * device->depth_bits + 3 * device->colours * device->colour_bits);
  device->answer_words = 0;
  if (device->normals != 0) {
    device->answer_words += words_of(device->material_bits + 3 * device->normals * device->normal_bits);
  }
  if (device->coordinates != 0) {
    device->answer_words +=
        words_of(device->texture_bits + device->repeat_bits + 3 * device->coordinates * device->coordinate_bits);
  }
  return NULL;
}

void hs_set_frame(const hs_device* device, uint32_t width, uint32_t height, uint32_t r, uint32_t g, uint32_t b) {
  set(device, HS_FRAME, width << HS_FRAME_WIDTH_LSB | height << HS_FRAME_HEIGHT_LSB);
  set(device, HS_BACKGROUND, r << HS_BACKGROUND_R_LSB | g << HS_BACKGROUND_G_LSB | b << HS_BACKGROUND_B_LSB);
}

void hs_set_buffers(const hs_device* device, uint32_t index, uint32_t depth, uint32_t planes) {
  set(device, HS_INDEX_BASE, index);
  set(device, HS_DEPTH_BASE, depth);
  set(device, HS_PLANES_BASE, planes);
}

uint32_t hs_take(hs_memory* memory, size_t bytes) {
  const uint32_t at = (memory->used + 63u) & ~63u;
  if (at > memory->size || bytes > memory->size - at) return HS_NOWHERE;
  memory->used = at + (uint32_t)bytes;
  return memory->address + at;
}

/* Bits one after the other, from bit 0 of the byte at `bytes` on. */
typedef struct {
  uint8_t* bytes;
  uint32_t bit;
} packer;

static void put(packer* to, uint64_t value, uint32_t width) {
  uint32_t done;
  for (done = 0; done < width;) {
    const uint32_t in_byte = to->bit % 8, take = width - done < 8 - in_byte ? width - done : 8 - in_byte;
    const uint32_t mask = ((1u << take) - 1) << in_byte;
    uint8_t* const byte = &to->bytes[to->bit / 8];
    *byte = (uint8_t)((*byte & ~mask) | ((uint32_t)(value >> done) << in_byte & mask));
    to->bit += take;
    done += take;
  }
}

/* Goes on with the next 64-bit word. */
static void fill(packer* to) {
  while (to->bit % 64 != 0) put(to, 0, 8 - to->bit % 8);
}

static packer packer_at(const hs_memory* memory, uint32_t address) {
  packer to;
  to.bytes = memory->bytes + (address - memory->address);
  to.bit = 0;
  return to;
}

/* Of a record the first field is the most significant, so the last one comes first. */
uint32_t hs_put_triangles(const hs_device* device, hs_memory* memory, const hs_triangle* triangles, size_t count) {
  const uint32_t address = hs_take(memory, count * device->triangle_words * 8);
  packer to;
  size_t n;
  if (address == HS_NOWHERE) return address;
  to = packer_at(memory, address);
  for (n = 0; n < count; ++n) {
    const hs_vertex* const v = triangles[n].vertex;
    const int colours = (int)device->colours;
    int i;
    for (i = colours - 1; i >= 0; --i) put(&to, v[i].b, device->colour_bits);
    for (i = colours - 1; i >= 0; --i) put(&to, v[i].g, device->colour_bits);
    for (i = colours - 1; i >= 0; --i) put(&to, v[i].r, device->colour_bits);
    for (i = 2; i >= 0; --i) put(&to, v[i].depth, device->depth_bits);
    for (i = 2; i >= 0; --i) put(&to, (uint32_t)v[i].y, device->coord_bits);
    for (i = 2; i >= 0; --i) put(&to, (uint32_t)v[i].x, device->coord_bits);
    fill(&to);
  }
  return address;
}

uint32_t hs_put_answers(const hs_device* device, hs_memory* memory, const hs_answer* answers, size_t count) {
  const uint32_t address = hs_take(memory, count * device->answer_words * 8);
  packer to;
  size_t n;
  if (address == HS_NOWHERE) return address;
  to = packer_at(memory, address);
  for (n = 0; n < count; ++n) {
    const hs_answer* const answer = &answers[n];
    int vertex, axis;
    if (device->normals != 0) {
      for (vertex = (int)device->normals - 1; vertex >= 0; --vertex) {
        for (axis = 2; axis >= 0; --axis) put(&to, (uint32_t)answer->normal[vertex][axis], device->normal_bits);
      }
      put(&to, answer->material, device->material_bits);
      fill(&to);
    }
    if (device->coordinates != 0) {
      for (axis = (int)device->coordinates - 1; axis >= 0; --axis) {
        for (vertex = 2; vertex >= 0; --vertex) put(&to, answer->coordinate[vertex][axis], device->coordinate_bits);
      }
      put(&to, answer->repeats, device->repeat_bits);
      put(&to, answer->texture, device->texture_bits);
      fill(&to);
    }
  }
  return address;
}

uint32_t hs_put_records(hs_memory* memory, const uint64_t* values, const uint8_t* widths, size_t fields, size_t count) {
  uint32_t bits = 0, address;
  size_t n, i;
  packer to;
  for (i = 0; i < fields; ++i) bits += widths[i];
  address = hs_take(memory, count * words_of(bits) * 8);
  if (address == HS_NOWHERE) return address;
  to = packer_at(memory, address);
  for (n = 0; n < count; ++n) {
    for (i = fields; i-- > 0;) put(&to, values[n * fields + i], widths[i]);
    fill(&to);
  }
  return address;
}

void hs_list_begin(hs_list* list, hs_memory* memory, size_t commands) {
  list->memory = memory;
  list->address = hs_take(memory, commands * 8);
  list->commands = 0;
  list->room = list->address == HS_NOWHERE ? 0 : (uint32_t)commands;
  list->wrong = 0;
}

static void command(hs_list* list, uint32_t what, uint32_t ends, uint32_t kind, uint32_t count, uint32_t address) {
  packer to;
  if (list->commands == list->room || address == HS_NOWHERE || count >> 24 != 0) {
    list->wrong = 1;
    return;
  }
  to = packer_at(list->memory, list->address + 8 * list->commands++);
  put(&to, address, 32);
  put(&to, count, 24);
  put(&to, kind, 3);
  put(&to, ends, 1);
  put(&to, what, 4);
}

void hs_list_draw(hs_list* list, uint32_t triangles, uint32_t count, int ends) {
  command(list, kDraw, ends != 0, 0, count, count == 0 ? 0 : triangles);
}
void hs_list_load(hs_list* list, hs_kind kind, uint32_t records, uint32_t count) {
  command(list, kLoad, 0, (uint32_t)kind, count, records);
}
void hs_list_answers(hs_list* list, uint32_t answers) { command(list, kAnswers, 0, 0, 0, answers); }
void hs_list_wait_tested(hs_list* list) { command(list, kWait, 0, 0, 0, 0); }
void hs_list_wait_out(hs_list* list) { command(list, kWait, 0, 1, 0, 0); }
void hs_list_end(hs_list* list) { command(list, kEnd, 0, 0, 0, 0); }

int hs_start(const hs_device* device, const hs_list* list) {
  if (list->wrong || list->commands == 0) return 0;
  set(device, HS_COMMANDS, list->address);
  set(device, HS_CONTROL, HS_CONTROL_START_MASK);
  return 1;
}

void hs_stop(const hs_device* device) { set(device, HS_CONTROL, HS_CONTROL_STOP_MASK); }

int hs_busy(const hs_device* device) { return (get(device, HS_STATUS) & HS_STATUS_BUSY_MASK) != 0; }

hs_state hs_status(const hs_device* device) {
  const uint32_t value = get(device, HS_STATUS);
  hs_state state;
  state.busy = FIELD(value, HS_STATUS_BUSY) != 0;
  state.done = FIELD(value, HS_STATUS_DONE) != 0;
  state.stopped = FIELD(value, HS_STATUS_STOPPED) != 0;
  state.error = FIELD(value, HS_STATUS_ERROR) != 0;
  state.error_kind = FIELD(value, HS_STATUS_ERROR_KIND);
  state.error_client = FIELD(value, HS_STATUS_ERROR_CLIENT);
  return state;
}

hs_counters hs_count(const hs_device* device) {
  hs_counters counters;
  uint32_t i;
  counters.cycles = get(device, HS_CYCLES);
  counters.frames = get(device, HS_FRAMES);
  counters.drawn = get(device, HS_DRAWN);
  counters.visible = get(device, HS_VISIBLE);
  counters.triangle_waits = get(device, HS_TRIANGLE_WAITS);
  counters.video_waits = get(device, HS_VIDEO_WAITS);
  for (i = 0; i < 6; ++i) counters.read[i] = get(device, HS_BYTES_READ + 4 * i);
  for (i = 0; i < 3; ++i) counters.written[i] = get(device, HS_BYTES_WRITTEN + 4 * i);
  return counters;
}

void hs_enable_interrupts(const hs_device* device, uint32_t mask) { set(device, HS_INTERRUPT_ENABLE, mask); }

uint32_t hs_happened(const hs_device* device) {
  const uint32_t value = get(device, HS_INTERRUPT_PENDING);
  set(device, HS_INTERRUPT_PENDING, value);
  return value;
}
