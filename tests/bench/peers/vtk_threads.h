#pragma once

namespace lacuna::peers {

/// Gives VTK's filters so many threads. @return what runs them
const char* set_vtk_threads(int threads);

}  // namespace lacuna::peers
