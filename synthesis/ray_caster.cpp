// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ray_caster.h"

#include <tbb/task_arena.h>

#include <limits>
#include <string>

#include "gestalt/core/base/error.h"

namespace gestalt::synthesis {

RayCaster::RayCaster(std::vector<const Body*> bodies) : bodies_(std::move(bodies)) {
  // Embree takes as many threads as the arena it is called in. One scene needs no more than one, and the thread
  // sanitizer does not see into Embree's loops.
  tbb::task_arena(1).execute([this] { set_up(); });
}

void RayCaster::set_up() {
  device_ = rtcNewDevice(nullptr);
  if (!device_) throw Error("Embree cannot be set up (code " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
  scene_ = rtcNewScene(device_);
  for (const Body* body : bodies_) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const Mesh& mesh = body->mesh;
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    const Eigen::Isometry3f pose = body->pose.cast<float>();
    for (const Vertex& vertex : mesh.vertices) {
      Eigen::Map<Eigen::Vector3f> position(positions);
      position = pose * vertex.position;
      positions += 3;
    }
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), mesh.triangles.size()));
    for (const Triangle& triangle : mesh.triangles)
      for (const int corner : triangle.corners) *corners++ = unsigned(corner);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_);
}

RayCaster::~RayCaster() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

Hit RayCaster::cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
  RTCRayHit query{};
  query.ray.org_x = origin.x();
  query.ray.org_y = origin.y();
  query.ray.org_z = origin.z();
  query.ray.dir_x = direction.x();
  query.ray.dir_y = direction.y();
  query.ray.dir_z = direction.z();
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  intersect(scene_, query);
  Hit hit;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;

  const Body& body = *bodies_[query.hit.geomID];
  const Triangle& triangle = body.mesh.triangles[query.hit.primID];
  const auto corner = [&](int i) -> const Vertex& {
    return body.mesh.vertices[std::size_t(triangle.corners[std::size_t(i)])];
  };
  const float u = query.hit.u, v = query.hit.v, w = 1 - u - v;
  hit.body = int(query.hit.geomID);
  hit.part = triangle.part;
  hit.distance = query.ray.tfar;
  const Eigen::Vector3f normal = w * corner(0).normal + u * corner(1).normal + v * corner(2).normal;
  hit.normal = (body.pose.linear().cast<float>() * normal).normalized();
  if (hit.normal.dot(direction) > 0) hit.normal = -hit.normal;
  hit.texture = w * corner(0).texture + u * corner(1).texture + v * corner(2).texture;
  return hit;
}

bool RayCaster::visible(const Eigen::Vector3f& surface_point, const Eigen::Vector3f& from) const {
  const Eigen::Vector3f way = surface_point - from;
  const float length = way.norm();
  constexpr float skin = 0.003f;
  RTCRay ray{};
  ray.org_x = from.x();
  ray.org_y = from.y();
  ray.org_z = from.z();
  ray.dir_x = way.x();
  ray.dir_y = way.y();
  ray.dir_z = way.z();
  ray.tfar = 1 - skin / length;
  ray.mask = ~0u;
  find_occlusion(scene_, ray);
  return ray.tfar > 0;
}

}  // namespace gestalt::synthesis
