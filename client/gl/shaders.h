#pragma once

namespace platon::shaders {

// GLSL 3.30 without the #version line. Colours are blended as sRGB values, without conversion to linear light.

/// Prepended to all shaders that draw on a face. Defines `depthInFace`, the distance to the nearest edge.
extern const char* const kFaceGeometry;

/// Prepended to fragment shaders that draw parts of a face, after kFaceGeometry: has the input `place`.
extern const char* const kInk;

extern const char* const kFaceVertex;
extern const char* const kFaceFragment;
/// Segments of a level: rods with round ends, and their shadows on the face.
extern const char* const kRibbonVertex;
extern const char* const kRibbonFragment;
/// Marks of the editor: flat strokes with round ends.
extern const char* const kMarkVertex;
extern const char* const kMarkFragment;
/// Round markers on a face: goal, start, shadow of a player.
extern const char* const kMarkerVertex;
extern const char* const kMarkerFragment;
extern const char* const kBallVertex;
extern const char* const kBallFragment;
/// The dark background.
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
