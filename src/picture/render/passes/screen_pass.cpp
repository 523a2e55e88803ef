#include "render/passes/screen_pass.h"

#include <cstdint>
#include <vector>

#include "render/encoding.h"

namespace poinsot {

ScreenPass::ScreenPass()
    : program_("screen.vert", "screen.frag"),
      alpha_(program_.at("alpha")),
      table_(GlTexture::make()) {
    const std::vector<std::uint16_t> table = Encoder().table();
    constexpr int row = 256;
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, table_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16UI, row, static_cast<GLsizei>(table.size() / row), 0,
                 GL_RED_INTEGER, GL_UNSIGNED_SHORT, table.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glActiveTexture(GL_TEXTURE0);
}

void ScreenPass::draw(const GlTexture& light, int width_px, int height_px, GLuint framebuffer,
                      ScreenAlpha alpha) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_px, height_px);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    program_.use();
    glUniform1i(alpha_, static_cast<GLint>(alpha));
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, table_.id());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, light.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    glEnable(GL_BLEND);
}

}  // namespace poinsot
