#pragma once

namespace platon::shaders {

// GLSL 3.30 without the #version line. Colours are sRGB values and blended as such.

/// Stands before the shaders of everything that lies on a face: `depthInFace` is the distance to the nearest edge.
extern const char* const kFaceGeometry;

extern const char* const kFaceVertex;
extern const char* const kFaceFragment;
/// Lines of a level: rounded rods, and before them the dark they leave on the face.
extern const char* const kRibbonVertex;
extern const char* const kRibbonFragment;
/// Round things on a face: goal, start, shadows.
extern const char* const kMarkerVertex;
extern const char* const kMarkerFragment;
extern const char* const kBallVertex;
extern const char* const kBallFragment;
/// Fills what nothing else covers.
extern const char* const kBackgroundVertex;
extern const char* const kBackgroundFragment;
extern const char* const kStarVertex;
extern const char* const kStarFragment;
extern const char* const kTextVertex;
extern const char* const kTextFragment;
/// Rectangles with rounded corners.
extern const char* const kPanelVertex;
extern const char* const kPanelFragment;

}  // namespace platon::shaders
