// On its own, as C++17: VTK 9.1's vtkSMPTools.h is no valid C++20.
#include "tests/bench/peers/vtk_threads.h"

#include <vtkSMPTools.h>

namespace lacuna::peers {

const char* set_vtk_threads(int threads) {
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(threads);
    return vtkSMPTools::GetBackend();
}

}  // namespace lacuna::peers
