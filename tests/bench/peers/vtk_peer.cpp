#include "tests/bench/peers/vtk_peer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>

#include "core/base/stopwatch.h"

namespace lacuna::peers {

struct VtkPeer::Parts {
    Volume volume;  // keeps the voxels VTK reads in place
    vtkNew<vtkImageData> image;
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkFixedPointVolumeRayCastMapper> caster;
    vtkNew<vtkVolume> actor;
    vtkNew<vtkFlyingEdges3D> triangles;
    vtkNew<vtkUnsignedCharArray> pixels;
    glm::ivec2 size{0};
    bool iso = false;
};

namespace {

void share_voxels(const Volume& volume, vtkImageData& image) {
    const GridGeometry& grid = volume.geometry();
    image.SetDimensions(grid.size.x, grid.size.y, grid.size.z);
    image.SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
    image.SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
    vtkNew<vtkUnsignedShortArray> values;
    auto* voxels = const_cast<unsigned short*>(reinterpret_cast<const unsigned short*>(volume.data()));
    values->SetArray(voxels, vtkIdType(grid.voxel_count()), 1);
    image.GetPointData()->SetScalars(values);
}

void put_property(const Scene& scene, vtkVolumeProperty& property) {
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    if (scene.mode == ViewMode::mip) {
        color->AddRGBPoint(scene.window.lo, 0, 0, 0);
        color->AddRGBPoint(scene.window.hi, 1, 1, 1);
        opacity->AddPoint(scene.window.lo, 1);
        opacity->AddPoint(scene.window.hi, 1);
    } else {
        for (const TransferPoint& p : scene.classification.tf.points) {
            color->AddRGBPoint(p.value, p.color.r, p.color.g, p.color.b);
            opacity->AddPoint(p.value, p.opacity);
        }
    }
    property.SetColor(color);
    property.SetScalarOpacity(opacity);
    property.SetScalarOpacityUnitDistance(scene.classification.tf.unit_distance_mm);
    property.SetInterpolationTypeToLinear();
    property.SetShade(scene.mode == ViewMode::ea && scene.shading == Shading::phong);
    property.SetAmbient(0.2);
    property.SetDiffuse(0.7);
    property.SetSpecular(0.3);
    property.SetSpecularPower(20);
}

void put_camera(const Scene& scene, vtkRenderer& renderer) {
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    vtkCamera* camera = renderer.GetActiveCamera();
    camera->SetPosition(rays.eye.x, rays.eye.y, rays.eye.z);
    camera->SetFocalPoint(rays.target.x, rays.target.y, rays.target.z);
    camera->SetViewUp(rays.up.x, rays.up.y, rays.up.z);
    camera->SetViewAngle(2 * glm::degrees(std::atan(0.5 * scene.size.y * rays.pixel_mm / rays.distance_mm)));
    renderer.ResetCameraClippingRange();
}

}  // namespace

VtkPeer::VtkPeer(const Scene& scene, double step, int threads) : parts_(std::make_unique<Parts>()) {
    Parts& p = *parts_;
    p.volume = scene.volume;
    p.size = scene.size;
    p.iso = scene.mode == ViewMode::iso;
    share_voxels(scene.volume, *p.image);
    p.window->SetOffScreenRendering(1);
    p.window->SetSize(scene.size.x, scene.size.y);
    p.window->SetMultiSamples(0);
    p.window->AddRenderer(p.renderer);
    p.renderer->SetBackground(0, 0, 0);
    if (p.iso) {
        p.triangles->SetInputData(p.image);
        p.triangles->SetValue(0, scene.iso);
        p.triangles->ComputeNormalsOn();
        p.triangles->ComputeGradientsOff();
        p.triangles->ComputeScalarsOff();
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(p.triangles->GetOutputPort());
        mapper->ScalarVisibilityOff();
        vtkNew<vtkActor> surface;
        surface->SetMapper(mapper);
        vtkProperty* look = surface->GetProperty();
        look->SetInterpolationToPhong();
        look->SetColor(scene.surface_color.r, scene.surface_color.g, scene.surface_color.b);
        look->SetAmbient(0.2);
        look->SetDiffuse(0.7);
        look->SetSpecular(0.3);
        look->SetSpecularPower(20);
        p.renderer->AddActor(surface);
        return;
    }
    p.caster->SetInputData(p.image);
    const double distance_mm = step * scene.volume.geometry().smallest_spacing_mm();
    p.caster->SetAutoAdjustSampleDistances(0);
    p.caster->SetLockSampleDistanceToInputSpacing(0);
    p.caster->SetSampleDistance(float(distance_mm));
    p.caster->SetInteractiveSampleDistance(float(distance_mm));
    p.caster->SetImageSampleDistance(1);
    p.caster->SetMinimumImageSampleDistance(1);
    p.caster->SetMaximumImageSampleDistance(1);
    p.caster->SetNumberOfThreads(threads);
    if (scene.mode == ViewMode::mip) p.caster->SetBlendModeToMaximumIntensity();
    vtkNew<vtkVolumeProperty> property;
    put_property(scene, *property);
    p.actor->SetProperty(property);
    p.actor->SetMapper(p.caster);
    p.renderer->AddVolume(p.actor);
}

VtkPeer::~VtkPeer() = default;

double VtkPeer::draw(const Scene& scene) {
    Parts& p = *parts_;
    const Stopwatch watch;
    if (p.iso && p.triangles->GetValue(0) != scene.iso) p.triangles->SetValue(0, scene.iso);
    if (p.iso) p.triangles->Update();  // the camera's clipping range needs the surface's bounds
    put_camera(scene, *p.renderer);
    p.window->Render();
    p.window->WaitForCompletion();
    p.window->GetRGBACharPixelData(0, 0, p.size.x - 1, p.size.y - 1, 0, p.pixels);
    return watch.ms();
}

double VtkPeer::caster_ms() const { return parts_->iso ? 0.0 : parts_->caster->GetTimeToDraw() * 1e3; }

Frame VtkPeer::picture() const {
    const Parts& p = *parts_;
    Frame frame;
    frame.size = p.size;
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels(), 0);
    for (int y = 0; y < p.size.y; ++y)
        for (int x = 0; x < p.size.x; ++x) {
            const unsigned char* from = p.pixels->GetPointer(4 * (vtkIdType(p.size.y - 1 - y) * p.size.x + x));
            frame.color[std::size_t(y) * std::size_t(p.size.x) + std::size_t(x)] =
                glm::vec4(from[0], from[1], from[2], 255) / 255.0f;
        }
    return frame;
}

}  // namespace lacuna::peers
