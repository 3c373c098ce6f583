/* SPDX-License-Identifier: Apache-2.0 */
/* The driver of hs_system: what a processor says to it. One C file, no heap, no operating system.

   Registers are reached by two functions that you give, and memory is a piece that both sides see: `bytes` is where the
   processor has it, `address` where the AXI4 port of hs_system has the same byte. Caches are yours: write them back
   before hs_start.

     hs_device device;
     hs_memory memory = {bytes, address, size, 0};
     hs_list list;
     const char *wrong = hs_open(&device, (hs_bus){read_register, write_register, context});
     hs_set_frame(&device, 640, 480, 0, 0, 0);
     hs_list_begin(&list, &memory, 16);
     hs_list_draw(&list, hs_put_triangles(&device, &memory, triangles, count), count, 1);
     hs_list_end(&list);
     hs_start(&device, &list);
     while (hs_busy(&device)) {}

   What does not fit into the piece of memory has the address HS_NOWHERE, and a list with it or with too many commands
   is not started. */
#ifndef HALFSPACE_DRIVER_HALFSPACE_H_
#define HALFSPACE_DRIVER_HALFSPACE_H_

#include <stddef.h>
#include <stdint.h>

#include "driver/halfspace_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

#define HS_NOWHERE 0xffffffffu

typedef struct {
  uint32_t (*read)(void* context, uint32_t offset);
  void (*write)(void* context, uint32_t offset, uint32_t value);
  void* context;
} hs_bus;

typedef struct {
  uint8_t* bytes;
  uint32_t address, size, used;
} hs_memory;

/* What hs_open found. */
typedef struct {
  hs_bus bus;
  uint32_t bus_bytes, lanes_x, lanes_y, width, height, triangles;
  uint32_t coord_bits, subpixel_bits, depth_bits, colour_bits, colours;
  uint32_t normals, normal_bits, material_bits;
  uint32_t coordinates, coordinate_bits, texture_bits, repeat_bits;
  uint32_t outside_frame, outside_planes;
  uint32_t triangle_words, answer_words; /* of 64 bits */
} hs_device;

/* Positions in the grid of 2^-subpixel_bits pixel; depth 0 is nearest. Flat: the colour of the first one counts. */
typedef struct {
  int32_t x, y;
  uint32_t depth;
  uint16_t r, g, b;
} hs_vertex;

typedef struct {
  hs_vertex vertex[3];
} hs_triangle;

/* What is answered to `visible`, of a triangle: what the configuration has of it counts. */
typedef struct {
  uint32_t material;
  int32_t normal[3][3]; /* of each vertex x, y, z; flat: of the first one */
  uint32_t texture, repeats;
  uint32_t coordinate[3][3]; /* of each vertex s, t, q */
} hs_answer;

typedef enum { HS_LIGHT = 0, HS_MATERIAL = 1, HS_TEXTURE = 2, HS_TEXEL = 3 } hs_kind;

typedef struct {
  hs_memory* memory;
  uint32_t address, commands, room, wrong;
} hs_list;

typedef struct {
  int busy, done, stopped, error;
  uint32_t error_kind, error_client;
} hs_state;

typedef struct {
  uint32_t cycles, frames, drawn, visible, triangle_waits, video_waits;
  uint32_t read[6], written[3]; /* bytes, by the clients of halfspace_registers.h */
} hs_counters;

/* NULL, or a sentence. */
const char* hs_open(hs_device* device, hs_bus bus);

/* For the next start. */
void hs_set_frame(const hs_device* device, uint32_t width, uint32_t height, uint32_t r, uint32_t g, uint32_t b);
/* Where the buffers are that the configuration has in memory. */
void hs_set_buffers(const hs_device* device, uint32_t index, uint32_t depth, uint32_t planes);

/* A piece of `bytes` on a boundary of 64 bytes, or HS_NOWHERE. */
uint32_t hs_take(hs_memory* memory, size_t bytes);
uint32_t hs_put_triangles(const hs_device* device, hs_memory* memory, const hs_triangle* triangles, size_t count);
uint32_t hs_put_answers(const hs_device* device, hs_memory* memory, const hs_answer* answers, size_t count);
/* Records of a stream that is loaded: of each `fields` values, the first one most significant, in as many bits as
   `widths` says of it; each record begins with a 64-bit word. */
uint32_t hs_put_records(hs_memory* memory, const uint64_t* values, const uint8_t* widths, size_t fields, size_t count);

void hs_list_begin(hs_list* list, hs_memory* memory, size_t commands);
/* `ends`: the last of them ends the frame; of none, a frame without more of them. */
void hs_list_draw(hs_list* list, uint32_t triangles, uint32_t count, int ends);
void hs_list_load(hs_list* list, hs_kind kind, uint32_t records, uint32_t count);
/* From the next triangle on. Every triangle is tested then. */
void hs_list_answers(hs_list* list, uint32_t answers);
void hs_list_wait_tested(hs_list* list);
void hs_list_wait_out(hs_list* list);
void hs_list_end(hs_list* list);

/* 0: it was not started, as the list has no place for all of its commands. */
int hs_start(const hs_device* device, const hs_list* list);
void hs_stop(const hs_device* device);
int hs_busy(const hs_device* device);
hs_state hs_status(const hs_device* device);
hs_counters hs_count(const hs_device* device);
/* Bits of HS_INTERRUPT_PENDING; hs_happened clears what it gives. */
void hs_enable_interrupts(const hs_device* device, uint32_t mask);
uint32_t hs_happened(const hs_device* device);

#ifdef __cplusplus
}
#endif

#endif /* HALFSPACE_DRIVER_HALFSPACE_H_ */
