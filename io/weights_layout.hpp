#pragma once

namespace delone::io {

/// What a layout of weight files calls the parts of one side.
struct WeightsSideNames {
  const char *what, *size, *rank, *shape, *x, *y, *mask, *fraction;
  const char *num_corners, *corner_x, *corner_y, *area;
};

/// What the layouts call the same things.
struct WeightsNames {
  const char *weight, *source_index, *target_index, *num_links;
  WeightsSideNames source, target;
};

inline constexpr WeightsNames esmf_names{
    "S",
    "col",
    "row",
    "n_s",
    {"source", "n_a", "src_grid_rank", "src_grid_dims", "xc_a", "yc_a", "mask_a",
     "frac_a", "nv_a", "xv_a", "yv_a", "area_a"},
    {"target", "n_b", "dst_grid_rank", "dst_grid_dims", "xc_b", "yc_b", "mask_b",
     "frac_b", "nv_b", "xv_b", "yv_b", "area_b"}};

inline constexpr WeightsNames scrip_names{
    "remap_matrix",
    "src_address",
    "dst_address",
    "num_links",
    {"source", "src_grid_size", "src_grid_rank", "src_grid_dims", "src_grid_center_lon",
     "src_grid_center_lat", "src_grid_imask", "src_grid_frac", "src_grid_corners",
     "src_grid_corner_lon", "src_grid_corner_lat", "src_grid_area"},
    {"target", "dst_grid_size", "dst_grid_rank", "dst_grid_dims", "dst_grid_center_lon",
     "dst_grid_center_lat", "dst_grid_imask", "dst_grid_frac", "dst_grid_corners",
     "dst_grid_corner_lon", "dst_grid_corner_lat", "dst_grid_area"}};

}  // namespace delone::io
