// SPDX-License-Identifier: BSD-3-Clause
// JSON schemas of Foxglove's messages, as far as they are used here: field names and types as
// docs.foxglove.dev has them.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCHEMAS_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCHEMAS_H_

namespace gmapping_spa::view {

#define GMAPPING_SPA_NUMBER R"({"type":"number"})"
#define GMAPPING_SPA_INTEGER R"({"type":"integer"})"
#define GMAPPING_SPA_TEXT R"({"type":"string"})"
#define GMAPPING_SPA_NUMBERS R"({"type":"array","items":{"type":"number"}})"
#define GMAPPING_SPA_TIME \
  R"({"type":"object","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}})"
#define GMAPPING_SPA_XYZ                                                           \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},)" \
  R"("z":{"type":"number"}}})"
#define GMAPPING_SPA_XYZW                                                          \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},)" \
  R"("z":{"type":"number"},"w":{"type":"number"}}})"
#define GMAPPING_SPA_POSE                                          \
  R"({"type":"object","properties":{"position":)" GMAPPING_SPA_XYZ \
  R"(,"orientation":)" GMAPPING_SPA_XYZW "}}"
// An object with a time and a frame, and what is appended: ,"name":schema
#define GMAPPING_SPA_STAMPED(title)                                                         \
  R"({"title":")" title R"(","type":"object","properties":{"timestamp":)" GMAPPING_SPA_TIME \
  R"(,"frame_id":)" GMAPPING_SPA_TEXT

inline constexpr const char* kPoseSchema =
    GMAPPING_SPA_STAMPED("foxglove.PoseInFrame") R"(,"pose":)" GMAPPING_SPA_POSE "}}";

inline constexpr const char* kPosesSchema = GMAPPING_SPA_STAMPED(
    "foxglove.PosesInFrame") R"(,"poses":{"type":"array","items":)" GMAPPING_SPA_POSE "}}}";

inline constexpr const char* kGridSchema = GMAPPING_SPA_STAMPED(
    "foxglove.Grid") R"(,"pose":)" GMAPPING_SPA_POSE R"(,"column_count":)" GMAPPING_SPA_INTEGER
                     R"(,"cell_size":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"}}})"
                     R"(,"row_stride":)" GMAPPING_SPA_INTEGER
                     R"(,"cell_stride":)" GMAPPING_SPA_INTEGER
                     R"(,"fields":{"type":"array","items":{"type":"object","properties":{"name":{"type":"string"},)"
                     R"("offset":{"type":"integer"},"type":{"type":"integer"}}}})"
                     R"(,"data":{"type":"string","contentEncoding":"base64"}}})";

inline constexpr const char* kScanSchema =
    GMAPPING_SPA_STAMPED("foxglove.LaserScan") R"(,"pose":)" GMAPPING_SPA_POSE
                                               R"(,"start_angle":)" GMAPPING_SPA_NUMBER
                                               R"(,"end_angle":)" GMAPPING_SPA_NUMBER
                                               R"(,"ranges":)" GMAPPING_SPA_NUMBERS
                                               R"(,"intensities":)" GMAPPING_SPA_NUMBERS "}}";

inline constexpr const char* kTransformsSchema =
    R"({"title":"foxglove.FrameTransforms","type":"object","properties":{"transforms":)"
    R"({"type":"array","items":{"type":"object","properties":{"timestamp":)" GMAPPING_SPA_TIME
    R"(,"parent_frame_id":)" GMAPPING_SPA_TEXT R"(,"child_frame_id":)" GMAPPING_SPA_TEXT
    R"(,"translation":)" GMAPPING_SPA_XYZ R"(,"rotation":)" GMAPPING_SPA_XYZW "}}}}}";

inline constexpr const char* kLogSchema =
    R"({"title":"foxglove.Log","type":"object","properties":{"timestamp":)" GMAPPING_SPA_TIME
    R"(,"level":)" GMAPPING_SPA_INTEGER R"(,"message":)" GMAPPING_SPA_TEXT
    R"(,"name":)" GMAPPING_SPA_TEXT R"(,"file":)" GMAPPING_SPA_TEXT
    R"(,"line":)" GMAPPING_SPA_INTEGER "}}";

inline constexpr const char* kSceneSchema =
    R"({"title":"foxglove.SceneUpdate","type":"object","properties":{"deletions":)"
    R"({"type":"array","items":{"type":"object"}},"entities":{"type":"array","items":)"
    R"({"type":"object"}}}})";

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCHEMAS_H_
