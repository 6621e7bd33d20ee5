/* SPDX-FileCopyrightText: 2026 the lithe authors
 * SPDX-License-Identifier: MIT
 * A camera walks towards a .lithe character; each step pulls the pages that it needs and prints what would be drawn. */
#define _POSIX_C_SOURCE 200112L
#include <lithe/runtime.h>
#include <stdio.h>
#include <stdlib.h>

static void* takeMemory(void* user, size_t size, size_t alignment) {
  void* memory = NULL; /* lithe asks for an alignment of at most 64 */
  return (void)user, (void)alignment, posix_memalign(&memory, 64, size) == 0 ? memory : NULL;
}
static void freeMemory(void* user, void* memory, size_t size) { (void)user, (void)size, free(memory); }
static const lithe_allocator kAllocator = {NULL, takeMemory, freeMemory};

static void* readBytes(FILE* file, uint64_t offset, size_t size) {
  void* bytes = malloc(size);
  const int whole = bytes && fseek(file, (long)offset, SEEK_SET) == 0 && fread(bytes, 1, size, file) == size;
  return whole ? bytes : (free(bytes), NULL);
}

/* Opens the head of the file: a few KiB that say everything about the character but its surface. */
static lithe_result openAsset(FILE* file, lithe_asset** asset) {
  uint64_t size = LITHE_PEEK_BYTES;
  void* bytes = readBytes(file, 0, LITHE_PEEK_BYTES);
  lithe_result result = bytes ? lithe_peek(bytes, LITHE_PEEK_BYTES, &size) : LITHE_ERROR_TRUNCATED;
  free(bytes);
  if (result != LITHE_OK) return result;
  bytes = readBytes(file, 0, (size_t)size);
  result = bytes ? lithe_asset_open(&kAllocator, bytes, (size_t)size, NULL, asset) : LITHE_ERROR_TRUNCATED;
  free(bytes);
  return result;
}

static lithe_result pullLevel(lithe_asset* asset, FILE* file, uint32_t level) {
  lithe_request request;
  lithe_result result = LITHE_OK;
  while (result == LITHE_OK && (result = lithe_asset_next_request(asset, level, &request)) == LITHE_OK) {
    void* page = readBytes(file, request.offset, request.size);
    result = page ? lithe_asset_supply(asset, request.page, page, request.size, NULL) : LITHE_ERROR_TRUNCATED;
    free(page);
  }
  return result == LITHE_COMPLETE ? LITHE_OK : result;
}

/* Chooses a level for 60 degrees on 1080 rows and a pixel of error, pulls what it would like, draws what it gets. */
static lithe_result step(lithe_asset* asset, FILE* file, float distance) {
  const lithe_view view = {.pixels_per_radian = 935, .near_distance = 0.1f, .threshold_px = 1, .hysteresis = 0.1f};
  lithe_instance instance = {.center = {0, 0, distance}, .scale = 1, .bias = 1, .level = LITHE_UNDRAWN};
  const lithe_crowd crowd = {(const lithe_asset*[]){asset}, &instance, sizeof instance, 1, 1};
  uint32_t wanted = 0;
  lithe_level level;
  lithe_result result = lithe_select(&crowd, &view, 1, &wanted, NULL);
  if (result == LITHE_OK) result = pullLevel(asset, file, wanted);
  if (result == LITHE_OK) result = lithe_select(&crowd, &view, 1, NULL, NULL);
  if (result == LITHE_OK) result = lithe_asset_level(asset, instance.level, &level);
  if (result == LITHE_OK)
    printf("from %6.1f units: level %2u, %6u triangles, error %.5f, %llu bytes\n", distance, instance.level,
           level.triangle_count, level.error, (unsigned long long)level.bytes_end);
  return result;
}

int main(int argc, char** argv) {
  FILE* file = argc == 2 ? fopen(argv[1], "rb") : NULL;
  lithe_asset* asset = NULL;
  lithe_asset_info info;
  if (!file) return fprintf(stderr, "usage: %s CHARACTER.lithe\n", argv[0]), 2;
  lithe_result result = openAsset(file, &asset);
  if (result == LITHE_OK) {
    lithe_asset_describe(asset, &info);
    printf("%u triangles, %u joints, %u levels, %llu bytes\n", info.triangle_count, info.joint_count, info.level_count,
           (unsigned long long)info.file_bytes);
    for (float far = 256; far >= 0.25f && result == LITHE_OK; far /= 4)
      result = step(asset, file, far * info.rest_diagonal);
  }
  if (result != LITHE_OK) fprintf(stderr, "%s: %s\n", argv[1], lithe_result_name(result));
  lithe_asset_close(asset);
  fclose(file);
  return result == LITHE_OK ? 0 : 1;
}
