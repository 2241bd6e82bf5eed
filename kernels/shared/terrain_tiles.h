// Ground in tiles, one layout for host and device (terrain/terrain.clh). A tile of level L has 256 x 256
// cells, each as wide as 2^L cells of the map. Squares of 256 x 256 cells of the map, in rows, are the pages:
// each says which tile lies there, as the float 16 slot + level, exact up to 2^20 slots.
//
// The pool of floats begins with the maxima of whole squares, level 8 of the map's pyramid and up, for which
// 2 x pages are kept; then come the slots.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_TILES_H
#define OFFING_KERNELS_SHARED_TERRAIN_TILES_H

// What a map does beyond its edges, MAP_EDGE of kernels.
#define TERRAIN_EDGE_ENDS 0
#define TERRAIN_EDGE_REPEATS 1
#define TERRAIN_EDGE_MIRRORS 2

#define TERRAIN_TILE_LOG2 8
#define TERRAIN_TILE_CELLS 256
#define TERRAIN_TILE_POSTS 257
#define TERRAIN_PAGE_LEVELS 16  // a page's slot counts in these

// A slot: heights [257][257] m; maxima of 2 x 2 cells and more, levels 1 ... 7 of the tile, each [256 >>
// level] squared; slopes [257][257], an int a post: x in its lower half, z in its upper half.
#define TERRAIN_SLOT_MAXIMA (TERRAIN_TILE_POSTS * TERRAIN_TILE_POSTS)
#define TERRAIN_SLOT_SLOPES (TERRAIN_SLOT_MAXIMA + 21844)
#define TERRAIN_SLOT_FLOATS (TERRAIN_SLOT_SLOPES + TERRAIN_TILE_POSTS * TERRAIN_TILE_POSTS)
#define TERRAIN_SLOPE_STEPS 512.0f  // of a slope of 1; the steepest that fit are 64

#endif
