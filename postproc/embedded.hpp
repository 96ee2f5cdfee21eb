#pragma once

#include <string_view>

#include "postproc/figures/scripts.hpp"

/// Text files compiled into the program (postproc/CMakeLists.txt), so that it needs none beside itself.
namespace thalweg::embedded {

extern const std::string_view view_script;   // postproc/view/view.py
extern const std::string_view hover_script;  // postproc/view/hover.js
extern const std::string_view scene_script;  // postproc/view/scene/scene.js with vtk.js; empty when built without npm

}  // namespace thalweg::embedded
