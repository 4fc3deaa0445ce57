// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sensor.h"

#include "active_stereo.h"
#include "kinect.h"
#include "time_of_flight.h"

namespace gestalt::synthesis {

std::vector<double> eyes_of(SensorModel sensor) {
  switch (sensor) {
    case SensorModel::structured_light:
      break;
    case SensorModel::active_stereo:
      return {left_imager_x, right_imager_x};
    case SensorModel::time_of_flight:
      return {time_of_flight_camera_x};
  }
  return {infrared_camera_x, projector_x};
}

Measurement measure_depth(SensorModel sensor, const IdealView& view, const Camera& camera, Random& random) {
  switch (sensor) {
    case SensorModel::structured_light:
      break;
    case SensorModel::active_stereo:
      return measure_active_stereo(view, camera, random);
    case SensorModel::time_of_flight:
      return measure_time_of_flight(view, camera, random);
  }
  return measure_structured_light(view, camera, random);
}

}  // namespace gestalt::synthesis
