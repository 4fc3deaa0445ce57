// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Embree 3 or 4, whichever CMake found; their queries differ in what they are given besides the ray.
#if GESTALT_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace gestalt::synthesis {

#if GESTALT_EMBREE_VERSION >= 4

inline void intersect(RTCScene scene, RTCRayHit& query) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect1(scene, &query, &arguments);
}

inline void find_occlusion(RTCScene scene, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcOccluded1(scene, &ray, &arguments);
}

#else

inline RTCIntersectContext coherent_rays() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

inline void intersect(RTCScene scene, RTCRayHit& query) {
  RTCIntersectContext context = coherent_rays();
  rtcIntersect1(scene, &context, &query);
}

inline void find_occlusion(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context = coherent_rays();
  rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace gestalt::synthesis
