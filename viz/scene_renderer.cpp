#include "viz/scene_renderer.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOrderIndependentTranslucentPass.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkTranslucentPass.h>

#include <array>
#include <utility>

namespace facetmill {

namespace {

class TwoSizePass : public vtkOrderIndependentTranslucentPass {
public:
    static TwoSizePass* New();
    vtkTypeMacro(TwoSizePass, vtkOrderIndependentTranslucentPass);

    void Render(const vtkRenderState* state) override {
        std::array<int, 2> size{};
        if (state->GetFrameBuffer()) {
            state->GetWindowSize(size.data());
        } else {
            int x = 0, y = 0;
            state->GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &x, &y);
        }
        if (size != size_) {
            swap();
            if (size != size_) ++sized_;
            size_ = size;
        }
        vtkOrderIndependentTranslucentPass::Render(state);
    }
    void ReleaseGraphicsResources(vtkWindow* window) override {
        for (int set = 0; set < 2; ++set) {
            vtkOrderIndependentTranslucentPass::ReleaseGraphicsResources(window);
            size_ = {};
            swap();
        }
    }
    std::size_t sized() const { return sized_; }

private:
    TwoSizePass() {
        for (vtkTextureObject*& texture : textures_)
            texture = vtkTextureObject::New();
    }
    ~TwoSizePass() override {
        for (vtkTextureObject* texture : textures_)
            texture->Delete();
        if (framebuffer_) framebuffer_->Delete();
    }
    /// Textures and the framebuffer that they are attached to go together.
    void swap() {
        std::swap(TranslucentRGBATexture, textures_[0]);
        std::swap(TranslucentRTexture, textures_[1]);
        std::swap(TranslucentZTexture, textures_[2]);
        std::swap(Framebuffer, framebuffer_);
        std::swap(size_, other_size_);
    }

    std::array<vtkTextureObject*, 3> textures_{};
    vtkOpenGLFramebufferObject* framebuffer_ = nullptr;
    std::array<int, 2> size_{}, other_size_{};
    std::size_t sized_ = 0;
};
vtkStandardNewMacro(TwoSizePass);

} // namespace

vtkStandardNewMacro(SceneRenderer);

SceneRenderer::SceneRenderer() {
    vtkNew<vtkTranslucentPass> props;
    TranslucentPass = TwoSizePass::New(); // whose last one to hold it is vtkOpenGLRenderer
    TranslucentPass->SetTranslucentPass(props);
}

std::size_t SceneRenderer::textures_sized() const {
    return static_cast<const TwoSizePass*>(TranslucentPass)->sized();
}

} // namespace facetmill
