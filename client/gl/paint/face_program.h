#pragma once

#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Makes `program`, whose shaders have kFaceGeometry, that of the following draw calls, which draw on this face.
void useOnFace(ShaderProgram& program, const StageModel& stage, const FaceView& view);

/// How bright a face is: brightest where it faces the light, which moves with the camera.
float litOf(const FaceView& view);

}  // namespace platon
