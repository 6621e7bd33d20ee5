/* SPDX-FileCopyrightText: 2026 the lithe authors
 * SPDX-License-Identifier: MIT
 *
 * lithe runtime: opens a .lithe character, takes its pages, and produces GPU-ready skinned vertex and index buffers for
 * every level; chooses the level of every instance by its error on screen, and fills indirect draws.
 *
 * The host owns memory, input/output, time, threads and the GPU. Nothing here reads files, takes locks, starts threads,
 * looks at a clock or keeps global state; nothing allocates after lithe_asset_open except lithe_asset_supply and
 * lithe_asset_reserve.
 *
 * Words: a *node* is a vertex of some level (position and skin); a *wedge* is one GPU vertex: a node plus normal,
 * tangent, uvs and colours. A *split* replaces a node by its two children. A *level* is a complete mesh; level 0 is the
 * coarsest. A *page* is what is read, checked and decoded at once; level k needs every page before its page_end.
 * All levels of an asset share one vertex buffer that only grows: a finer level appends vertices and brings its own
 * indices, and never changes what a frame in flight may be reading.
 *
 * Threads: an asset may be read (every function taking `const lithe_asset*`) by any number of threads at once.
 * lithe_asset_supply, lithe_asset_reserve, lithe_asset_evict and lithe_asset_close need it alone. Different assets are
 * independent.
 *
 * Errors: bytes are hostile, callers are friends. A damaged file gives LITHE_ERROR_* and leaves the object as it was;
 * it never makes the runtime read or write out of bounds, loop, or allocate beyond what the checked header states. A
 * wrong argument gives LITHE_ERROR_INVALID_ARGUMENT (in builds with LITHE_ASSERT defined it calls LITHE_ASSERT(0)
 * first).
 */
#ifndef LITHE_RUNTIME_H
#define LITHE_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) || defined(__clang__)
#define LITHE_API __attribute__((visibility("default")))
#else
#define LITHE_API
#endif
#if defined(__cplusplus) && __cplusplus >= 201703L
#define LITHE_NODISCARD [[nodiscard]]
#else
#define LITHE_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Results --------------------------------------------------------------------------------------------------- */

/* Values are pinned. 0: done. 1..15: the normal flow of things. From 16: errors; the object is unchanged. */
typedef enum lithe_result {
  LITHE_OK = 0,
  LITHE_PENDING = 1,  /* more bytes are needed first */
  LITHE_COMPLETE = 2, /* nothing is left to request */

  LITHE_ERROR_TRUNCATED = 16,       /* fewer bytes than the file's own tables state */
  LITHE_ERROR_NOT_THIS_FORMAT = 17, /* the magic is missing: not a .lithe file */
  LITHE_ERROR_VERSION_TOO_NEW = 18, /* written by a newer major version */
  LITHE_ERROR_CORRUPT = 19,         /* a checksum or a check of docs/format.md failed */
  LITHE_ERROR_LIMIT = 20,           /* states counts beyond the format's limits */

  LITHE_ERROR_INVALID_ARGUMENT = 32, /* a caller's mistake */
  LITHE_ERROR_BUFFER_TOO_SMALL = 33, /* the destination cannot hold the result */
  LITHE_ERROR_NOT_RESIDENT = 34,     /* the level's pages have not been supplied */

  LITHE_ERROR_OUT_OF_MEMORY = 48 /* the host's allocator returned NULL */
} lithe_result;

/* The name of a result, such as "LITHE_ERROR_CORRUPT"; "unknown" for other values. Never NULL, static. */
LITHE_API const char* lithe_result_name(lithe_result result);

/* The library's version: major * 10000 + minor * 100 + patch. */
LITHE_API uint32_t lithe_version(void);

/* ---- Opening ---------------------------------------------------------------------------------------------------- */

/* The host's memory. Kept by the object it is given to; the functions must be callable from the thread that calls
 * lithe_asset_open, _supply, _evict or _close. alignment is a power of two, at most 64. free is told the size. */
typedef struct lithe_allocator {
  void* user;
  void* (*alloc)(void* user, size_t size, size_t alignment);
  void (*free)(void* user, void* memory, size_t size);
} lithe_allocator;

typedef struct lithe_asset lithe_asset;

/* Why bytes were refused: the number of the reader check in docs/format.md and the byte offset it concerns. */
typedef struct lithe_diagnosis {
  uint32_t check;  /* 0 when nothing was refused */
  uint64_t offset; /* from the start of the file */
} lithe_diagnosis;

/* How many bytes from the start of the file lithe_asset_open needs.
 * bytes, size   the first bytes of the file [at least LITHE_PEEK_BYTES]
 * head_bytes    receives the count: LITHE_PEEK_BYTES .. 16 MiB, usually a few KiB
 * returns LITHE_OK; LITHE_PENDING when size < LITHE_PEEK_BYTES (head_bytes = LITHE_PEEK_BYTES); LITHE_ERROR_*. */
#define LITHE_PEEK_BYTES 64
LITHE_NODISCARD LITHE_API lithe_result lithe_peek(const void* bytes, size_t size, uint64_t* head_bytes);

/* Opens an asset from the head of its file. The bytes are copied; they may go when this returns.
 * bytes, size   the first bytes of the file, at least the count lithe_peek states
 * diagnosis     may be NULL; says what was refused
 * asset         receives the object; close it with lithe_asset_close */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_open(const lithe_allocator* allocator, const void* bytes,
                                                        size_t size, lithe_diagnosis* diagnosis, lithe_asset** asset);

/* Frees everything. NULL is allowed. */
LITHE_API void lithe_asset_close(lithe_asset* asset);

/* ---- What an asset says of itself: all of it known after open --------------------------------------------------- */

#define LITHE_MAX_UV_SETS 8
#define LITHE_MAX_COLOR_SETS 2
#define LITHE_MAX_INFLUENCES 8
#define LITHE_NO_LEVEL 0xffffffffu
#define LITHE_MAX_VIEWS 8
#define LITHE_MAX_PLANES 6
#define LITHE_NO_INDEX 0xffffffffu

typedef struct lithe_asset_info {
  uint64_t file_bytes;
  uint32_t node_count;  /* of the scene graph: joints, their ancestors, and nodes with rigid parts */
  uint32_t joint_count; /* matrices of a palette */
  uint32_t part_count;  /* one draw range per part and level */
  uint32_t material_count;
  uint32_t level_count;
  uint32_t page_count;
  uint32_t vertex_count;   /* GPU vertices of all levels together */
  uint32_t triangle_count; /* of the finest level */
  uint32_t max_influences; /* at every level [1..8] */
  uint32_t has_normals, has_tangents, uv_sets, color_sets;
  float position_offset[3]; /* bind space = position_offset + position_scale * snorm16 value / 32767 */
  float position_scale;
  float box_min[3], box_max[3]; /* of all vertices in bind space */
  float rest_diagonal;          /* of the source's own vertices: the unit of the relative errors that the bake prints */
  float posed_diagonal;         /* mean over the example poses */
} lithe_asset_info;

LITHE_API void lithe_asset_describe(const lithe_asset* asset, lithe_asset_info* info);

/* A node of the scene graph, parents before children. local = T * R * S. */
typedef struct lithe_node {
  const char* name; /* UTF-8, zero-terminated, lives as long as the asset; may be empty */
  uint32_t parent;  /* LITHE_NO_INDEX for a root */
  float translation[3];
  float rotation[4]; /* quaternion x, y, z, w */
  float scale[3];
} lithe_node;

/* One matrix of the palette: posed = world(node) * inverse_bind. */
typedef struct lithe_joint {
  uint32_t node;
  float inverse_bind[12];       /* 3 rows of 4: x' = m[0] x + m[1] y + m[2] z + m[3], ... */
  float box_min[3], box_max[3]; /* bind-space box of every vertex of every level that it influences, on 256 cells of the
                                   grid along each axis; min > max: none */
} lithe_joint;

typedef struct lithe_part {
  const char* name;
  const char* material;    /* the material's name in the source */
  uint32_t material_index; /* in the source file; LITHE_NO_INDEX for none */
  uint32_t rigid_node;     /* the node a rigid part hangs on, LITHE_NO_INDEX for a skinned part */
} lithe_part;

typedef struct lithe_level {
  float error;     /* largest posed distance to the original that the bake measured, bind-space units; grows
                      from the finest level to the coarsest */
  float error_rms; /* the same distance, root mean square */
  uint32_t triangle_count;
  uint32_t index_count;  /* 3 * triangle_count */
  uint32_t vertex_count; /* GPU vertices 0 .. vertex_count - 1 must be there to draw this level */
  uint32_t page_end;     /* needs the pages 0 .. page_end - 1 */
  uint64_t bytes_end;    /* the file's bytes up to here draw this level */
  uint32_t joint_count;  /* joints used at this level */
} lithe_level;

typedef struct lithe_page {
  uint64_t offset; /* from the start of the file */
  uint32_t size;   /* bytes */
  uint32_t level;  /* the level it belongs to */
} lithe_page;

/* Each: LITHE_OK or LITHE_ERROR_INVALID_ARGUMENT when index is out of range. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_node(const lithe_asset* asset, uint32_t index, lithe_node* node);
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_joint(const lithe_asset* asset, uint32_t index, lithe_joint* joint);
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_part(const lithe_asset* asset, uint32_t index, lithe_part* part);
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_level(const lithe_asset* asset, uint32_t index, lithe_level* level);
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_page(const lithe_asset* asset, uint32_t index, lithe_page* page);

/* ---- Streaming: lithe asks, the host reads ---------------------------------------------------------------------- */

typedef struct lithe_request {
  uint32_t page;
  uint32_t size;   /* bytes */
  uint64_t offset; /* from the start of the file */
} lithe_request;

/* The next page to read on the way to a level. Pages are needed in their order, so a host that reads ahead just reads
 * the pages after this one.
 * returns LITHE_OK and the request; LITHE_COMPLETE when the level is resident. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_next_request(const lithe_asset* asset, uint32_t level,
                                                                lithe_request* request);

/* The most bytes that supply will hold on the way to a level, its scratch included; with lithe_asset_reserve fewer. */
LITHE_API uint64_t lithe_asset_memory(const lithe_asset* asset, uint32_t level);

/* Makes room for a level at once, for a host that knows which one it will ask for: on the way there supply allocates
 * nothing but its scratch, and no array is moved. Without it the arrays grow level by level, each new block beside the
 * one that it replaces. What evict gives back it gives back all the same.
 * returns LITHE_OK; LITHE_ERROR_OUT_OF_MEMORY: what has been made room for so far is kept, and supply goes on as it can
 */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_reserve(lithe_asset* asset, uint32_t level);

/* Takes a page: checks it, decodes it, appends its nodes, wedges and faces. The bytes may go when this returns.
 * page          must be the one lithe_asset_next_request names; one that was supplied before is ignored (LITHE_OK)
 * diagnosis     may be NULL
 * returns LITHE_OK; LITHE_PENDING when an earlier page is missing (nothing is kept); LITHE_ERROR_*: the asset stays as
 * it was and the page may be supplied again. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_supply(lithe_asset* asset, uint32_t page, const void* bytes,
                                                          size_t size, lithe_diagnosis* diagnosis);

/* The finest level that can be drawn now, LITHE_NO_LEVEL before the first page. */
LITHE_API uint32_t lithe_asset_resident_level(const lithe_asset* asset);

/* Drops everything finer than `level` and frees its memory where the allocator lets it. Coarser levels keep working,
 * and their vertices keep their numbers. The dropped pages can be supplied again. Allocates; when the allocator fails
 * the asset keeps its memory but drops the levels all the same. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_evict(lithe_asset* asset, uint32_t level);

/* ---- Buffers: written in the host's layout, straight into the host's memory -------------------------------------- */

typedef enum lithe_format {
  LITHE_FORMAT_NONE = 0,
  LITHE_FORMAT_F32 = 1,     /* position xyz, normal xyz, tangent xyzw, uv xy, colour rgba, weights x max_influences */
  LITHE_FORMAT_SNORM16 = 2, /* int16: position xyz, 32767; normal octahedral x, y; tangent x, hand * (y + 1) / 2 */
  LITHE_FORMAT_SNORM8 = 3,  /* normal and tangent: 4 x int8 xyzw */
  LITHE_FORMAT_F16 = 4,     /* uv: 2 x IEEE half */
  LITHE_FORMAT_UNORM16 = 5, /* uv: 2 x uint16, only where the uvs are within 0..1; weights: uint16 that sum to 65535 */
  LITHE_FORMAT_UNORM8 = 6,  /* colour: 4 x uint8; weights: uint8 that sum to 255 */
  LITHE_FORMAT_U8 = 7,      /* joints, where joint_count <= 256 */
  LITHE_FORMAT_U16 = 8      /* joints */
} lithe_format;

typedef struct lithe_attribute {
  uint16_t format; /* a lithe_format; LITHE_FORMAT_NONE leaves the attribute out */
  uint16_t offset; /* bytes from the start of the vertex [multiple of the component's size] */
} lithe_attribute;

typedef struct lithe_vertex_layout {
  uint32_t struct_size; /* sizeof(lithe_vertex_layout) */
  uint32_t stride;      /* bytes from vertex to vertex [<= 2048] */
  uint32_t influences;  /* joints and weights written per vertex, padded with zeros [max_influences..8] */
  lithe_attribute position, normal, tangent;
  lithe_attribute uv[LITHE_MAX_UV_SETS];
  lithe_attribute color[LITHE_MAX_COLOR_SETS];
  lithe_attribute joints, weights;
} lithe_vertex_layout;

/* A layout with everything the asset has: f32 position, oct snorm16 normal and tangent, f16 uvs, unorm8 colours, u8 or
 * u16 joints, unorm8 weights, packed, stride a multiple of 4. */
LITHE_API lithe_vertex_layout lithe_vertex_layout_default(const lithe_asset* asset);

/* Writes the vertices [first, first + count) to memory that may be write-combined (written once, in order).
 * destination   receives count * layout->stride bytes; bytes of a vertex that no attribute covers are left alone
 * returns LITHE_ERROR_NOT_RESIDENT when a vertex has not been supplied. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_write_vertices(const lithe_asset* asset,
                                                                  const lithe_vertex_layout* layout, uint32_t first,
                                                                  uint32_t count, void* destination, size_t size);

typedef enum lithe_index_type { LITHE_INDEX_U16 = 2, LITHE_INDEX_U32 = 4 } lithe_index_type;

/* Where a part's triangles lie in a level's indices. */
typedef struct lithe_range {
  uint32_t first_index;
  uint32_t index_count;
} lithe_range;

/* Writes a level's indices, grouped by part, and where each part lies.
 * type          U16 only where the level's vertex_count <= 65536
 * destination   receives level.index_count * type bytes
 * ranges        may be NULL; receives info.part_count ranges
 * Costs time in the level's triangles. */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_write_indices(const lithe_asset* asset, uint32_t level,
                                                                 lithe_index_type type, void* destination, size_t size,
                                                                 lithe_range* ranges);

/* Puts a level's triangles in an order that a GPU's vertex cache likes, within each part's range (Sander, Nehab and
 * Barczak, "Fast Triangle Reordering for Vertex Locality and Reduced Overdraw", 2007): lithe_asset_write_indices writes
 * them in the order of the splits that made them, which a cache does not like at all. Time is linear in the indices and
 * vertices. Order memory that is cheap to read, and copy it to the GPU. Triangles keep their corners and winding; the
 * same indices give the same order everywhere. Not for indices that something else refers to by place.
 * indices       index_count of them, below vertex_count
 * ranges        as lithe_asset_write_indices gives them: one after the other, covering all indices
 * scratch       lithe_order_scratch(index_count, vertex_count) bytes, aligned to 4, for the time of the call
 * returns LITHE_OK; LITHE_ERROR_INVALID_ARGUMENT or LITHE_ERROR_BUFFER_TOO_SMALL: the indices are as they were */
LITHE_NODISCARD LITHE_API lithe_result lithe_order_indices(void* indices, lithe_index_type type, uint32_t index_count,
                                                           const lithe_range* ranges, uint32_t range_count,
                                                           uint32_t vertex_count, void* scratch, size_t scratch_size);
LITHE_API uint64_t lithe_order_scratch(uint32_t index_count, uint32_t vertex_count);

/* For a geomorph: the vertex of level `level - 1` that each vertex of `level` came from, for the vertices
 * [0, vertex_count of level). A vertex that level - 1 has already maps to itself.
 * destination   receives vertex_count uint32_t */
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_write_morph_sources(const lithe_asset* asset, uint32_t level,
                                                                       uint32_t* destination, size_t count);

/* ---- The hierarchy, for tools and view-dependent refinement ------------------------------------------------------ */

/* Read-only views into the asset, valid until the next supply, evict or close. Structure of arrays. */
typedef struct lithe_hierarchy {
  uint32_t node_count, wedge_count, face_count; /* resident */
  const uint16_t* node_position;    /* 3 per node, grid coordinates: bind space = grid_origin + grid_step * value */
  const uint32_t* node_parent;      /* LITHE_NO_INDEX for a root; ids grow from coarse to fine */
  const uint32_t* node_first_child; /* the two children are this and this + 1; LITHE_NO_INDEX for a leaf (so far) */
  const uint32_t* wedge_node;
  const uint32_t* wedge_parent; /* the wedge it came from, LITHE_NO_INDEX in the base */
  const uint16_t* wedge_part;
  const uint32_t* face_wedges; /* 3 per face, the finest resident cut; a face belongs to every cut in which its
                                  corners' ancestors are three different nodes */
  float grid_origin[3];
  float grid_step;
} lithe_hierarchy;

LITHE_API void lithe_asset_hierarchy(const lithe_asset* asset, lithe_hierarchy* hierarchy);

/* Nodes, wedges and faces of a level: every id below these counts belongs to it or to a coarser one. */
typedef struct lithe_level_extent {
  uint32_t node_count, wedge_count, face_count;
} lithe_level_extent;
LITHE_NODISCARD LITHE_API lithe_result lithe_asset_level_extent(const lithe_asset* asset, uint32_t level,
                                                                lithe_level_extent* extent);

/* ---- Bounds ------------------------------------------------------------------------------------------------------ */

/* The box of the posed character: a posed vertex is a convex combination of its joints' transforms of it, so it lies in
 * the hull of the transformed joint boxes.
 * palette      joint_count matrices of 12 floats (3 rows of 4) = world(node) * inverse_bind
 * box          receives min xyz, max xyz in the palette's space */
LITHE_API void lithe_asset_posed_box(const lithe_asset* asset, const float* palette, float box[6]);

/* ---- Selection: the level of every instance by its error on screen ----------------------------------------------- */

typedef struct lithe_view {
  float position[3];       /* the camera, world space */
  float pixels_per_radian; /* perspective: viewport height / (2 tan(vertical field of view / 2)).
                              0: orthographic, then pixels_per_unit counts */
  float pixels_per_unit;   /* orthographic: viewport height / height of the view volume */
  float near_distance;     /* > 0; distances are not taken smaller */
  float threshold_px;      /* the largest error on this view's screen that is allowed, > 0 */
  float hysteresis;        /* 0..0.9: a coarser level than the current one is taken only when its error is below
                              threshold_px * (1 - hysteresis) */
  float least_px;          /* >= 0: a sphere that is smaller across than this is not seen. 0: none is too small */
  uint32_t plane_count;    /* 0..LITHE_MAX_PLANES: a sphere that is wholly outside one of the planes is not seen */
  float planes[LITHE_MAX_PLANES][4]; /* world space, unit normals: inside is x p[0] + y p[1] + z p[2] + p[3] >= 0 */
} lithe_view;

/* One drawn character. The host fills it and keeps it from frame to frame; lithe_select reads `level` (hysteresis) and
 * writes it and `views`. All zero but for center, scale, bias and level is a good start. */
typedef struct lithe_instance {
  float center[3]; /* bounding sphere of the posed character, world space */
  float radius;
  float scale;         /* world units per bind-space unit of the asset (largest axis) */
  float bias;          /* multiplies the error: 2 asks for twice the quality; 1 normal */
  uint32_t asset;      /* index into the crowd's assets */
  uint8_t level;       /* LITHE_UNDRAWN: not chosen yet, or nothing resident; an instance that no view sees keeps it */
  uint8_t first_level; /* never coarser than this; 0: no bound */
  uint8_t end_level;   /* always coarser than this; 0: no bound */
  uint8_t views;       /* bit v: view v sees it */
} lithe_instance;

#define LITHE_UNDRAWN 0xffu

/* The instances that a call is about. They may be the beginning of larger structs of the host: a stride says so. A
 * range of them is a crowd too, which is how a crowd is split over threads. */
typedef struct lithe_crowd {
  const lithe_asset* const* assets;
  lithe_instance* instances;
  size_t instance_stride; /* bytes from one to the next, a multiple of 4; 0: sizeof(lithe_instance) */
  uint32_t asset_count;
  uint32_t instance_count;
} lithe_crowd;

typedef struct lithe_select_stats {
  uint64_t triangles;  /* of the chosen levels */
  uint32_t undrawable; /* instances whose asset has no resident level */
  uint32_t limited;    /* instances that would like a finer level than is resident */
  uint32_t unseen;     /* instances that no view sees; the other counts leave them out */
} lithe_select_stats;

/* Chooses for each instance the coarsest level whose error on screen is within the threshold of every view that sees
 * it, among the resident ones and those of its own bounds.
 *     error_px = level.error * scale * bias * pixels_per_radian / max(distance to the sphere, near_distance)
 * views          1 to LITHE_MAX_VIEWS, seen at the same time: split screens, the cascades of a shadow map (with higher
 *                thresholds). An instance is seen by a view where its sphere is inside all planes and not too small.
 * wanted_levels  may be NULL; per asset, raised (never lowered) to the finest level any seen instance would like: what
 *                to request next. The caller sets it to 0 before the frame's first call.
 * stats          may be NULL; added to
 * Never allocates. A crowd may be split in ranges over threads (with separate wanted_levels and stats). An instance
 * whose asset is not one ends the call with LITHE_ERROR_INVALID_ARGUMENT: those before it have been chosen. */
LITHE_NODISCARD LITHE_API lithe_result lithe_select(const lithe_crowd* crowd, const lithe_view* views,
                                                    uint32_t view_count, uint32_t* wanted_levels,
                                                    lithe_select_stats* stats);

/* The same within a budget: the best picture that `triangles` triangles can give. All thresholds are multiplied by the
 * smallest factor >= 1 with which the chosen levels have at most that many together, so the largest error on screen, in
 * thresholds, is as small as it can be, within a 128th. What is left then goes to the instances whose errors are alike
 * up to that, in their order; what remains unspent is less than the next finer level of any of those costs.
 * triangles  of all instances in all views that see them, each counted once. Where even the coarsest levels have more,
 *            those are chosen, and stats say so.
 * scratch    scratch_bytes, at least lithe_budget_scratch(), aligned to 8
 * factor     may be NULL; receives the factor: above 1 the budget rules. Infinity where even the coarsest levels have
 *            more.
 * Never allocates; the time is linear in the instances. One call for the whole crowd. */
LITHE_NODISCARD LITHE_API lithe_result lithe_select_within(const lithe_crowd* crowd, const lithe_view* views,
                                                           uint32_t view_count, uint64_t triangles,
                                                           uint32_t* wanted_levels, lithe_select_stats* stats,
                                                           void* scratch, size_t scratch_bytes, float* factor);
LITHE_API uint64_t lithe_budget_scratch(uint32_t instance_count);

/* For geomorphs (Hoppe 1996): how far each drawn instance's vertices are on the way to where the next coarser level has
 * them (lithe_asset_write_morph_sources). 1 up to where that level's error reaches the threshold, so levels change
 * while they look the same; from there on it falls to 0, linearly in the error, until the error is (1 + width)
 * thresholds. views, factor  as the levels were chosen with; factor is 1 after lithe_select width          > 0; 0.25
 * leaves the levels of an ordinary bake apart: a level that is still on its way when the next one takes over shows a
 * jump morphs         receives instance_count numbers 0..1; 0 for level 0 and for what is not drawn A level that comes
 * late from the disk is past its way when it arrives: let the host's own number fall from 1 then. Never allocates. A
 * crowd may be split in ranges over threads. */
LITHE_NODISCARD LITHE_API lithe_result lithe_morph_factors(const lithe_crowd* crowd, const lithe_view* views,
                                                           uint32_t view_count, float factor, float width,
                                                           float* morphs);

/* ---- Draws ------------------------------------------------------------------------------------------------------- */

/* The layout of VkDrawIndexedIndirectCommand and of glMultiDrawElementsIndirect's commands. */
typedef struct lithe_draw {
  uint32_t index_count;
  uint32_t instance_count;
  uint32_t first_index;
  int32_t vertex_offset;
  uint32_t first_instance;
} lithe_draw;

/* Where the host put an asset's buffers. */
typedef struct lithe_placement {
  int32_t vertex_offset;     /* of the asset's vertex 0 in the host's vertex buffer */
  uint32_t part_count;       /* as in the asset's info */
  uint32_t level_count;      /* levels below this have their indices in the host's index buffer */
  const lithe_range* ranges; /* [level * part_count + part]: absolute positions in the host's index buffer */
} lithe_placement;

/* What a draw is of: same index as in draws. */
typedef struct lithe_draw_key {
  uint32_t asset, level, part;
} lithe_draw_key;

/* How many draws and counters lithe_build_draws needs at most for these assets. */
LITHE_API uint32_t lithe_draws_bound(const lithe_placement* placements, uint32_t asset_count);

/* Groups instances by asset and level: one draw per part, each level's instances side by side.
 * placements     one per asset of the crowd, whose `assets` is not read
 * view_mask      instances that none of these views sees (bit v: view v) are left out; ~0u: those that no view sees
 * instance_order receives at most instance_count indices into the crowd: instance i of a draw is
 *                instance_order[draw.first_instance + i]; instances without a level are left out
 * draws, keys    receive at most lithe_draws_bound entries (keys may be NULL); empty parts and levels get none
 * counters       scratch, lithe_draws_bound entries
 * Never allocates; time linear in instances and draws. An instance whose level is not in the host's buffers is drawn
 * with the finest level that is. */
LITHE_NODISCARD LITHE_API lithe_result lithe_build_draws(const lithe_crowd* crowd, const lithe_placement* placements,
                                                         uint32_t view_mask, uint32_t* instance_order,
                                                         lithe_draw* draws, lithe_draw_key* keys, uint32_t* draw_count,
                                                         uint32_t* counters);

#ifdef __cplusplus
}
#endif
#endif /* LITHE_RUNTIME_H */
